// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tecnogamma_camera/recording.h"

namespace tecnogamma_camera {

/// One line of a folder's index.
struct RecordedFile {
  std::string file;         //!< in the folder, with / if it lies in a subfolder
  std::uint64_t frame = 0;  //!< unwrapped
  Nanoseconds device_time = 0;
  Nanoseconds time = 0;  //!< of the exposure on the host's clock
  std::uint32_t packets_lost = 0;
};

struct FolderIndex {
  std::vector<RecordedFile> files;
  int first_column = 0;    //!< [px] sensor column of the images' first
  int first_row = 0;       //!< [px]
  int sensor_columns = 0;  //!< [px] 0: as many as the images have
  int sensor_rows = 0;     //!< [px]
};

/// Reads an index: CSV with a header line. Columns, in any order: file, frame; and where known
/// device_time [ns], time [ns], packets_lost, first_column, first_row, sensor_columns, sensor_rows
/// (these four [px], the same in all lines). An empty field means not known.
/// @param source names the text in errors
/// @throw scan_cell_common::UnusableInput naming the line
FolderIndex parse_folder_index(const std::string& text, const std::string& source);

/// Opens a folder of images of 8 or 16 bit grey (PNG, PGM, TIFF, BMP) or of payloads (.bin: the
/// bytes as they came). With index.csv, the frames are the files named there. Without it, they are
/// all files in the order of their names (numbers in names by their value), numbered from 1. All
/// images must have the size and bits of the first.
/// @throw scan_cell_common::FileError, UnusableInput if folder, index or first image cannot be used
std::unique_ptr<Recording> open_folder_recording(const std::string& path);

}  // namespace tecnogamma_camera
