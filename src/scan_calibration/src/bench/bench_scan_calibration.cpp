// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <opencv2/core.hpp>

#include "scan_cell_common/tools/tool_main.h"
#include "session_figures.h"

int main(int argc, char** argv) {
  CLI::App app(
      "Calibrations from images: real sessions, accuracy of the corners, time to read them");
  return scan_cell_common::tool_main("bench_scan_calibration", app, argc, argv, [] {
    std::setvbuf(stdout, nullptr, _IOLBF, 0);  // minutes of work: each line as it is known
    cv::setNumThreads(1);                      // as the command does: views are read in parallel
    scan_calibration::print_real_sessions();
    scan_calibration::print_corner_accuracy();
    scan_calibration::print_reading_time();
    return 0;
  });
}
