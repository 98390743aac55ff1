// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace scan_cell {

/// Shows on stderr how a long work goes on: one line that is drawn anew on a terminal, or else a
/// line for each tenth.
class ProgressBar {
 public:
  /// @param title stands in front of the bar
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
