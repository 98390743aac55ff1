// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tecnogamma_camera/tecnogamma_relief.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "payload/payload_bytes.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::UnusableInput;

constexpr int kKernel = 32;             // [px] columns the LUPA3000 reads out together; chosen
constexpr std::size_t kThreshold = 4;   // [bytes] a row; thesis, section 3.2
constexpr std::size_t kCenter = 8;      // [bytes] a row; chosen
constexpr float kCenterUnit = 65536.F;  // [1/px] chosen

std::string to_text(const Region& region) {
  return fmt::format("{} x {} at {}, {}", region.width, region.height, region.x, region.y);
}

/// Reads the peaks of a payload of `rows` elements of `size` bytes.
void read_peaks(const std::uint8_t* bytes, std::size_t size, const Region& region,
                DecodedFrame& frame) {
  frame.has_peaks = true;
  for (int row = 0; row < region.height; ++row, bytes += size) {
    const int start = read_16(bytes);
    const int width = read_16(bytes + 2);
    if (width == 0) continue;
    if (start + width > region.width) {
      ++frame.impossible_peaks;
      continue;
    }
    const bool cut = start == 0 || start + width == region.width;  // the centre is unknown
    if (cut) continue;
    float column = static_cast<float>(start) + 0.5F * static_cast<float>(width - 1);
    if (size == kCenter) {
      column = static_cast<float>(read_32(bytes + 4)) / kCenterUnit;
      if (column > static_cast<float>(region.width - 1)) {
        ++frame.impossible_peaks;
        continue;
      }
    }
    frame.peaks.position[row] = static_cast<float>(region.x) + column;
    frame.peaks.width[row] = static_cast<float>(width);
  }
}

/// Some decimated images are as large as relief rows.
bool is_decimated(const TecnogammaFrameInfo& info, std::size_t columns, std::size_t rows) {
  const std::size_t step = info.decimation;
  if (step < 2) return false;
  const std::size_t least = (columns / step) * (rows / step);
  const std::size_t most = ((columns + step - 1) / step) * ((rows + step - 1) / step);
  return info.size >= least && info.size <= most;
}

void set_place(const Region& region, ImageView8& image) {
  image = {};
  image.columns = region.width;
  image.rows = region.height;
  image.first_column = region.x;
  image.first_row = region.y;
}

/// Reads the payload of a whole frame: peaks, or an image.
void read_payload(const std::uint8_t* begin, const TecnogammaFrameInfo& info, const Region& region,
                  DecodedFrame& frame) {
  const auto rows = static_cast<std::size_t>(region.height);
  const auto columns = static_cast<std::size_t>(region.width);
  if (is_decimated(info, columns, rows)) {
    throw UnusableInput("relief frame", fmt::format("an image decimated by {}", info.decimation),
                        "switch the decimation off");
  }
  if (info.size == kThreshold * rows || info.size == kCenter * rows) {
    frame.peaks.clear(region.y, region.height);
    read_peaks(begin, info.size / rows, region, frame);
  } else if (info.size == columns * rows) {
    frame.pixels.assign(begin, begin + info.size);
    frame.image.pixels = frame.pixels.data();
    frame.image.stride = region.width;
  } else {
    throw UnusableInput("relief frame",
                        fmt::format("payload of {} bytes for the region {}, decimation {}",
                                    info.size, to_text(region), info.decimation),
                        "a payload has 4 or 8 bytes per row, or one byte per pixel");
  }
}

}  // namespace

void TecnogammaSettings::check() const {
  using scan_cell_common::InvalidParameter;
  constexpr double kLongest = 1;  // [s] as the parameter's
  if (!(tick >= 0 && tick <= kLongest)) {
    throw InvalidParameter("payload_tick", fmt::format("{:g} s", tick),
                           "give the length of a tick, up to 1 s, or 0 if it is not known");
  }
  if (sensor_columns < kKernel || sensor_rows < 1) {
    throw InvalidParameter("sensor", fmt::format("{} x {} pixels", sensor_columns, sensor_rows),
                           fmt::format("give at least {} x 1", kKernel));
  }
}

TecnogammaDecoder::TecnogammaDecoder(const TecnogammaSettings& settings) : settings_(settings) {
  settings_.check();
}

void TecnogammaDecoder::describe(CameraDescription& camera) const {
  camera.sensor_columns = settings_.sensor_columns;
  camera.sensor_rows = settings_.sensor_rows;
  camera.region = {0, 0, settings_.sensor_columns, settings_.sensor_rows};
  camera.counter = kCounter16;
}

TecnogammaFrameInfo TecnogammaDecoder::read_info(const std::uint8_t* bytes) {
  TecnogammaFrameInfo info;
  info.time_counter = read_32(bytes);
  info.frame_counter = read_16(bytes + 4);
  info.first_kernel = bytes[6];
  info.kernels = bytes[7];
  info.first_row = read_16(bytes + 8);
  info.last_row = read_16(bytes + 10);
  info.decimation = bytes[12];
  // Bytes 16 to 19, the end of a frame, belong to run-length encoded images only.
  info.packets_lost = read_32(bytes + 20);
  info.offset = read_32(bytes + 24);
  info.size = read_32(bytes + 28);
  return info;
}

Region TecnogammaDecoder::region_of(const TecnogammaFrameInfo& info) const {
  const Region region{info.first_kernel * kKernel, info.first_row, info.kernels * kKernel,
                      info.last_row - info.first_row + 1};
  if (region.width < 1 || region.height < 1 || region.x + region.width > settings_.sensor_columns ||
      region.y + region.height > settings_.sensor_rows) {
    throw UnusableInput("relief frame", "region of " + to_text(region),
                        fmt::format("the sensor has {} x {} pixels", settings_.sensor_columns,
                                    settings_.sensor_rows));
  }
  return region;
}

std::size_t TecnogammaDecoder::decode(const ImageView8& payload,
                                      std::vector<DecodedFrame>& frames) const {
  const PayloadBytes bytes(payload);
  if (bytes.size() < kInfoSize) {
    throw UnusableInput("relief frame", fmt::format("cut off after {} bytes", bytes.size()),
                        fmt::format("the frame information alone has {} bytes", kInfoSize));
  }
  const TecnogammaFrameInfo info = read_info(bytes.data());
  const Region region = region_of(info);
  DecodedFrame& frame = begin_frame(frames, 0);
  frame.counter = info.frame_counter;
  if (settings_.tick > 0) frame.ticks = info.time_counter;
  frame.packets_lost = info.packets_lost;
  set_place(region, frame.image);
  if (info.packets_lost > 0) return 1;

  const std::size_t memory = bytes.size() - kInfoSize;
  if (info.offset > memory || info.size > memory - info.offset) {
    throw UnusableInput(
        "relief frame", fmt::format("cut off after {} bytes of memory", memory),
        fmt::format("its payload has {} bytes from byte {}", info.size, info.offset));
  }
  read_payload(bytes.data() + kInfoSize + info.offset, info, region, frame);
  return 1;
}

}  // namespace tecnogamma_camera
