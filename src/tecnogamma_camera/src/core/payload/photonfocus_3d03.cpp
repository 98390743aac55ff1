// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tecnogamma_camera/photonfocus_3d03.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "payload/payload_bytes.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;

constexpr int kBlockRows = 5;       // one of the 2D line, four of 3D data; MAN052
constexpr int kStatusColumns = 16;  // with image counter and time, 4 bits each
constexpr int kScanRows = 1024;     // [px] most that 10 bits hold

/// Bits `first` to `first` + 4 `count` - 1 of the status word: the lowest bits of its row.
std::uint32_t status(const std::uint8_t* row, int first, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i)
    value |= static_cast<std::uint32_t>(row[first / 4 + i] & 0x0F) << (4 * i);
  return value;
}

/// The camera fills up a combined frame that was cut short (manuals of the 3D02 and 3D06).
bool is_filler(const ImageView8& payload, int first_row) {
  constexpr std::uint8_t kFirst = 0xBB, kSecond = 0x44;  // of each row, the others are 0
  for (int i = 0; i < kBlockRows; ++i) {
    const std::uint8_t* const row = payload.row(first_row + i);
    if (row[0] != kFirst || row[1] != kSecond) return false;
    if (std::any_of(row + 2, row + payload.columns, [](std::uint8_t b) { return b != 0; }))
      return false;
  }
  return true;
}

}  // namespace

void Photonfocus3D03Settings::check() const {
  if (scan_first_row < -1 || scan_first_row >= sensor_rows) {
    throw InvalidParameter(
        "scan_first_row", fmt::format("{}", scan_first_row),
        fmt::format("give Peak0_3DY, 0 to {}, or -1 to ask the camera", sensor_rows - 1));
  }
  if (scan_rows < -1 || scan_rows == 0 || scan_rows > kScanRows) {
    throw InvalidParameter(
        "scan_rows", fmt::format("{}", scan_rows),
        fmt::format("give Peak0_3DH, 1 to {}, or -1 to ask the camera", kScanRows));
  }
}

Photonfocus3D03Decoder::Photonfocus3D03Decoder(const Photonfocus3D03Settings& settings)
    : asked_(settings), settings_(settings) {
  asked_.check();
}

void Photonfocus3D03Decoder::adapt(const FeatureReader& feature) {
  settings_ = asked_;
  const auto ask = [&](const char* name, int& value) {
    constexpr std::int64_t kMost = 65535;  // [px] as the parameters'
    const auto told = value < 0 ? feature(name) : std::nullopt;
    if (told) value = static_cast<int>(std::clamp<std::int64_t>(*told, 0, kMost));
  };
  ask("Peak0_3DY", settings_.scan_first_row);
  ask("Peak0_3DH", settings_.scan_rows);
  if (settings_.scan_first_row < 0) {
    throw InvalidParameter("scan_first_row", "-1, and the camera does not report it",
                           "give its Peak0_3DY");
  }
  if (settings_.scan_rows < 0 && settings_.with_image) {
    throw InvalidParameter("scan_rows", "-1, and the camera does not report it",
                           "give its Peak0_3DH");
  }
  if (settings_.scan_rows < 0) settings_.scan_rows = kScanRows;
  settings_.check();
  const auto refuse_unless = [&](const char* name, std::int64_t wanted) {
    const auto told = feature(name);
    if (!told || *told == wanted) return;
    throw UnusableInput(name, fmt::format("{}", *told), fmt::format("set it to {}", wanted));
  };
  refuse_unless("PeakDetector_NrOfPeaks", 1);
  refuse_unless("DataFormat3D", 0);
}

void Photonfocus3D03Decoder::describe(CameraDescription& camera) const {
  camera.sensor_columns = settings_.sensor_rows;
  camera.sensor_rows = settings_.sensor_columns;
  camera.region = {0, 0, camera.sensor_columns, camera.sensor_rows};
  camera.counter = kCounter24;
}

int Photonfocus3D03Decoder::first_row_of(const ImageView8& payload) const {
  return settings_.sensor_columns - payload.first_column - payload.columns;
}

std::size_t Photonfocus3D03Decoder::decode(const ImageView8& payload,
                                           std::vector<DecodedFrame>& frames) const {
  const std::string size = fmt::format("{} x {} bytes", payload.columns, payload.rows);
  if (payload.columns < kStatusColumns || payload.first_column < 0 || first_row_of(payload) < 0) {
    throw UnusableInput("3D03 frame", size,
                        fmt::format("a frame has one byte per column, {} to {} of them",
                                    kStatusColumns, settings_.sensor_columns));
  }
  const int image_rows = settings_.with_image ? settings_.scan_rows : 0;
  const int blocks = (payload.rows - image_rows) / kBlockRows;
  const bool whole = payload.rows > image_rows && (payload.rows - image_rows) % kBlockRows == 0;
  if (!whole || (settings_.with_image && blocks != 1)) {
    throw UnusableInput("3D03 frame", size,
                        settings_.with_image
                            ? fmt::format("in 2D&3D with {} scan rows a frame has {} rows",
                                          image_rows, image_rows + kBlockRows)
                            : "in 3Donly each combined frame has 5 rows");
  }
  std::size_t count = 0;
  for (int block = 0; block < blocks; ++block) {
    const int first_row = image_rows + block * kBlockRows;
    if (is_filler(payload, first_row)) continue;
    decode_block(payload, first_row + 1, begin_frame(frames, count++));
  }
  if (settings_.with_image && count == 1) turn_image(payload, frames[0]);
  return count;
}

void Photonfocus3D03Decoder::decode_block(const ImageView8& payload, int row,
                                          DecodedFrame& frame) const {
  const std::uint8_t* const rows[] = {payload.row(row), payload.row(row + 1), payload.row(row + 2),
                                      payload.row(row + 3)};
  frame.counter = status(rows[3], 0, 6);
  frame.ticks = status(rows[3], 32, 8);
  frame.image.columns = settings_.scan_rows;
  frame.image.rows = payload.columns;
  frame.image.first_column = settings_.scan_first_row;
  frame.image.first_row = first_row_of(payload);
  frame.has_peaks = true;
  frame.peaks.clear(frame.image.first_row, payload.columns);
  const auto end = static_cast<float>(
      std::min(settings_.scan_rows, settings_.sensor_rows - settings_.scan_first_row));
  for (int column = 0; column < payload.columns; ++column) {
    const Photonfocus3D03Peak peak =
        decode_photonfocus_peak(rows[0][column], rows[1][column], rows[2][column], rows[3][column]);
    if (peak.position == 0) continue;
    if (peak.position > end - 1) {
      ++frame.impossible_peaks;
      continue;
    }
    const int turned = payload.columns - 1 - column;
    constexpr float kClass = 16;  // [grey values] that share a height: 4 of 8 bits
    frame.peaks.position[turned] = static_cast<float>(settings_.scan_first_row) + peak.position;
    frame.peaks.width[turned] = static_cast<float>(peak.width);
    frame.peaks.intensity[turned] = kClass * static_cast<float>(peak.height) + 0.5F * (kClass - 1);
  }
}

void Photonfocus3D03Decoder::turn_image(const ImageView8& payload, DecodedFrame& frame) const {
  const int columns = frame.image.columns, rows = frame.image.rows;
  frame.pixels.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int column = 0; column < columns; ++column) {
    const std::uint8_t* const from = payload.row(column);
    for (int row = 0; row < rows; ++row)
      frame.pixels[static_cast<std::size_t>(row) * columns + column] = from[rows - 1 - row];
  }
  frame.image.pixels = frame.pixels.data();
  frame.image.stride = columns;
}

}  // namespace tecnogamma_camera
