// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <opencv2/core.hpp>

#include "session_figures.h"

int main() {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // minutes of work: each line as it is known
  cv::setNumThreads(1);                      // as the command does: views are read in parallel
  scan_calibration::print_real_sessions();
  scan_calibration::print_corner_accuracy();
  scan_calibration::print_reading_time();
}
