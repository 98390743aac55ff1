// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_calibration/session.h"
#include "scan_cell/session_sequence.h"

namespace scan_cell {

/// A session folder that grows view by view; after each it is whole (docs/scan_calibration.md).
/// Beside the peaks that count as a laser's line lies the image they were found in.
class SessionFolder {
 public:
  /// Makes the folder.
  /// @throw scan_cell_common::FileError if it cannot be made
  /// @throw scan_cell_common::Refused if it holds something already
  SessionFolder(const std::string& path, const scan_calibration::Board& board,
                const std::vector<std::string>& lasers);

  /// @throw scan_cell_common::FileError if it cannot be written
  void add(const TakenView& view);

 private:
  std::string path_;
  std::vector<std::string> lasers_;
  std::vector<scan_calibration::SessionView> views_;
};

}  // namespace scan_cell
