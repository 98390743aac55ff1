// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>  // NOLINT: struct sigaction is POSIX's

#include <utility>
#include <vector>

namespace scan_cell_common {

/// The signals that ask a program to end: SIGINT (Ctrl-C), SIGTERM, and SIGHUP (its terminal was
/// closed) unless it is ignored, as under nohup.
std::vector<int> ending_signals();

/// While it lives, these signals do not end the process but are recorded, so that a program can
/// make its work safe. One at a time.
class CatchInterrupts {
 public:
  CatchInterrupts();
  ~CatchInterrupts();
  CatchInterrupts(const CatchInterrupts&) = delete;
  CatchInterrupts& operator=(const CatchInterrupts&) = delete;

  /// Whether a signal has arrived since the latest of these objects was created.
  static bool interrupted();

 private:
  std::vector<std::pair<int, struct sigaction>> before_;
};

}  // namespace scan_cell_common
