// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <opencv2/core.hpp>

#include "session_figures.h"

int main() {
  cv::setNumThreads(1);  // as the command does: views are read in parallel
  scan_calibration::print_real_sessions();
  scan_calibration::print_corner_accuracy();
  scan_calibration::print_reading_time();
}
