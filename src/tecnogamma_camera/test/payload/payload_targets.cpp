// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "payload/payload_targets.h"

#include <cmath>
#include <memory>

#include "payload/payloads.h"
#include "recording/folder_recording.h"
#include "tecnogamma_camera/photonfocus_3d03.h"
#include "tecnogamma_camera/tecnogamma_relief.h"

namespace {

using namespace tecnogamma_camera;
using scan_cell_common::FuzzTarget;
using scan_cell_common::promise;

void check_peaks(const PeakProfile& peaks, const CameraDescription& camera) {
  const auto rows = static_cast<std::size_t>(peaks.rows());
  promise(peaks.width.size() == rows && peaks.intensity.size() == rows, "arrays of one length");
  promise(peaks.first_row >= 0 && peaks.first_row + peaks.rows() <= camera.sensor_rows,
          "rows on the sensor");
  for (std::size_t row = 0; row < rows; ++row) {
    const float position = peaks.position[row];
    if (std::isnan(position)) continue;
    promise(position >= 0 && position <= static_cast<float>(camera.sensor_columns - 1),
            "peaks on the sensor");
    promise(peaks.width[row] >= 0 && peaks.width[row] <= static_cast<float>(camera.sensor_columns),
            "a width");
  }
}

/// Checks that everything decoded makes sense, and that all its pixels can be read.
void check_frames(const PayloadDecoder& decoder, const std::vector<DecodedFrame>& frames,
                  std::size_t count) {
  CameraDescription camera;
  decoder.describe(camera);
  promise(count <= frames.size(), "no more frames than there are");
  for (std::size_t i = 0; i < count; ++i) {
    const DecodedFrame& frame = frames[i];
    promise(frame.counter >= camera.counter.first && frame.counter <= camera.counter.last,
            "a number of the counter");
    promise(frame.packets_lost == 0 || (!frame.has_peaks && frame.image.pixels == nullptr),
            "nothing of a frame that lost packets");
    if (frame.has_peaks) check_peaks(frame.peaks, camera);
    if (frame.image.pixels == nullptr) continue;
    unsigned sum = 0;
    for (int row = 0; row < frame.image.rows; ++row)
      for (int column = 0; column < frame.image.columns; ++column)
        sum += frame.image.row(row)[column];
    promise(sum <= 255U * static_cast<unsigned>(frame.image.rows * frame.image.columns), "pixels");
  }
}

FuzzTarget relief_target() {
  payloads::Relief threshold;
  threshold.spot(40, 5).spot(0, 0).spot(41, 6).spot(90, 6);
  payloads::Relief centers;
  centers.padding.clear();
  centers.center(40, 5, 42.25).center(0, 0, 0).center(41, 6, 43.5).center(90, 3, 91);
  payloads::Relief live;
  live.kernels = 1;
  live.payload.assign(32 * 4, '\x55');
  payloads::Relief lost = threshold;
  lost.packets_lost = 3;

  FuzzTarget target;
  target.name = "tecnogamma_relief";
  target.seeds = {threshold.bytes(), centers.bytes(), live.bytes(), lost.bytes()};
  target.words = {std::string("\0\0\0\0", 4), "\xFF\xFF\xFF\xFF", std::string("\x01\0", 2)};
  TecnogammaSettings settings;
  settings.tick = 1e-6;
  target.run = [decoder = std::make_shared<TecnogammaDecoder>(settings),
                frames = std::make_shared<std::vector<DecodedFrame>>()](const std::string& bytes) {
    check_frames(*decoder, *frames, decoder->decode(payloads::view(bytes), *frames));
  };
  return target;
}

/// The first bytes give the number of columns and whether an image comes first.
FuzzTarget photonfocus_target() {
  constexpr int kColumns = 17;
  payloads::Photonfocus sent(kColumns, 3);
  sent.number(0, 0xFFFFFF, 0xFFFFFFFF);
  sent.number(1, 0, 0);
  sent.set(0, 5, 14, 176, 10, 128);
  sent.set(1, 16, 4, 1, 63, 240);
  sent.fill(2);
  payloads::Photonfocus single(kColumns, 1);
  single.set(0, 3, 1, 0, 2, 0x70);

  FuzzTarget target;
  target.name = "photonfocus_3d03";
  target.seeds = {std::string("\x01\0", 2) + sent.bytes,
                  "\x01\x01" + std::string(8 * kColumns, '\x20') + single.bytes};
  target.words = {"\xBB\x44", std::string("\0\0\0\0", 4), "\xFF\xFF\xFF\xFF"};
  const auto make = [](bool with_image) {
    Photonfocus3D03Settings settings;
    settings.scan_first_row = 1000;
    settings.scan_rows = 8;
    settings.with_image = with_image;
    const auto decoder = std::make_shared<Photonfocus3D03Decoder>(settings);
    decoder->adapt([](const std::string&) { return std::nullopt; });
    return decoder;
  };
  target.run = [plain = make(false), with_image = make(true),
                frames = std::make_shared<std::vector<DecodedFrame>>()](const std::string& bytes) {
    if (bytes.size() < 2) return;
    const int columns = 16 + static_cast<unsigned char>(bytes[0]);
    const auto& decoder = (bytes[1] & 1) != 0 ? *with_image : *plain;
    const std::string payload = bytes.substr(2);
    check_frames(decoder, *frames, decoder.decode(payloads::view(payload, columns), *frames));
  };
  return target;
}

FuzzTarget index_target() {
  FuzzTarget target;
  target.name = "folder_index";
  target.seeds = {
      "file,frame\na.png,1\nb.png,2\n",
      "frame,file,device_time,time,packets_lost\r\n7,x/1.pgm,1000,1700000000000000000,0\r\n"
      "9,x/2.pgm,,,3\r\n",
      "file,frame,first_column,first_row,sensor_columns,sensor_rows\n"
      "1.tif,0,64,32,2048,1088\n2.tif,1,64,32,2048,1088\n"};
  target.words = {",", "\n", "file", "frame", "device_time", "..", "/", "\"", "sensor_rows"};
  target.run = [](const std::string& bytes) {
    const FolderIndex index = parse_folder_index(bytes, "index.csv");
    promise(!index.files.empty(), "files");
    for (const RecordedFile& file : index.files) {
      promise(!file.file.empty() && file.file.front() != '/', "a name in the folder");
      promise(("/" + file.file + "/").find("/../") == std::string::npos, "no way out of it");
      promise(file.device_time >= 0 && file.time >= 0, "times");
    }
    promise(index.first_column >= 0 && index.sensor_rows >= 0, "places");
  };
  return target;
}

}  // namespace

std::vector<FuzzTarget> payload_targets() {
  return {relief_target(), photonfocus_target(), index_target()};
}
