// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "acquisition/acquisition.h"

namespace tecnogamma_camera {

/// Writes frames into a folder that open_folder_recording() reads. They are written as PGM, which
/// takes the least time and keeps the bytes of a payload.
class FolderRecorder {
 public:
  /// @param folder is created; must be empty
  /// @throw scan_cell_common::FileError if the folder cannot be created or is not empty
  explicit FolderRecorder(const std::string& folder);

  /// A frame that lost packets is in the index, but has no file.
  /// @throw scan_cell_common::FileError if it cannot be written
  /// @throw scan_cell_common::Refused if it belongs to another start than the first frame, since
  /// the numbers start again there
  void add(const NumberedFrame& frame);

  std::uint64_t frames() const { return frames_; }

  /// Writes the index: without it the recording has neither numbers nor times.
  /// @throw scan_cell_common::FileError if it cannot be written
  void finish() const;

 private:
  std::string folder_;
  std::uint64_t frames_ = 0;
  std::optional<std::uint32_t> acquisition_;
  std::string index_;
};

}  // namespace tecnogamma_camera
