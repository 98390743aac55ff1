// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace scan_cell {

/// Shows the progress of long work on stderr: on a terminal one line that is redrawn, otherwise a
/// line for each tenth.
class ProgressBar {
 public:
  /// @param title shown in front of the bar
  explicit ProgressBar(const std::string& title);

  /// Ends the line.
  ~ProgressBar();

  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// @param progress 0 .. 1
  void show(const std::string& what, double progress);

 private:
  std::string title_;
  bool terminal_;
  int last_tenth_ = -1;
};

}  // namespace scan_cell
