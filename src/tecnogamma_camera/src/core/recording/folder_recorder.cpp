// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "recording/folder_recorder.h"

#include <fmt/format.h>

#include <filesystem>

#include "scan_cell_common/files/files.h"

namespace fs = std::filesystem;

namespace tecnogamma_camera {
namespace {

using scan_cell_common::FileError;

void append_row(const std::uint8_t* row, int columns, std::string& text) {
  text.append(reinterpret_cast<const char*>(row), static_cast<std::size_t>(columns));
}

void append_row(const std::uint16_t* row, int columns, std::string& text) {
  for (int column = 0; column < columns; ++column) {
    text += static_cast<char>(row[column] >> 8);
    text += static_cast<char>(row[column] & 0xFF);
  }
}

/// Portable grey map (P5): 8 bits a pixel, or 16 with the higher byte first.
std::string to_pgm(const GreyImage& image) {
  std::string text = fmt::format("P5\n{} {}\n{}\n", image.columns, image.rows,
                                 image.bytes_per_pixel() == 2 ? 65535 : 255);
  visit(image, [&text](const auto& view) {
    for (int row = 0; row < view.rows; ++row)
      append_row(view.row(row), view.columns, text);
  });
  return text;
}

std::string file_name(std::uint64_t number) {
  constexpr int kDigits = 7;  // chosen: five hours at 500 Hz
  return fmt::format("{:0{}}.pgm", number, kDigits);
}

}  // namespace

FolderRecorder::FolderRecorder(const std::string& folder) : folder_(folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw FileError(folder, failure.message(), "give a folder that can be created");
  if (!fs::is_empty(folder, failure) || failure)
    throw FileError(folder, "is not empty", "give a new folder");
  index_ =
      "file,frame,device_time,time,packets_lost,first_column,first_row,sensor_columns,sensor_"
      "rows\n";
}

void FolderRecorder::add(const NumberedFrame& frame) {
  if (acquisition_.value_or(frame.acquisition) != frame.acquisition) {
    throw scan_cell_common::Refused(folder_, "the camera restarted its counter",
                                    "record it into another folder");
  }
  acquisition_ = frame.acquisition;
  const auto& image = frame.frame.image;
  const std::string file = file_name(++frames_);
  if (image.pixels) scan_cell_common::save_text(folder_ + "/" + file, to_pgm(image));
  const auto add = [this](const auto& value) { index_ += fmt::format(",{}", value); };
  index_ += file;
  add(frame.counter);
  add(frame.frame.device_time);
  add(frame.time);
  add(frame.frame.packets_lost);
  add(image.first_column);
  add(image.first_row);
  add(frame.camera.sensor_columns);
  add(frame.camera.sensor_rows);
  index_ += "\n";
}

void FolderRecorder::finish() const {
  scan_cell_common::save_text(folder_ + "/index.csv", index_);
}

}  // namespace tecnogamma_camera
