// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_calibration/calibration_run.h"

namespace scan_calibration {

/// Where the results of a calibration go.
struct CalibrationFiles {
  std::string scanner;      //!< scanner model, YAML
  std::string camera_info;  //!< the camera alone, as ROS' camera_info_manager reads it
  std::string report;       //!< JSON; its page goes beside it: report.json -> report.html
};

/// scanner.yaml -> scanner_camera_info.yaml
std::string camera_info_file(const std::string& scanner);

/// @throw scan_cell_common::FileError if the folder of a result does not exist, or two results
/// would go to the same file
void check_writable(const CalibrationFiles& files);

/// The files that were written.
struct WrittenFiles {
  std::string report;        //!< JSON
  std::string page;          //!< HTML, self-contained
  std::string scanner;       //!< empty: not written
  std::string camera_info;   //!< empty: not written
  std::string kept_scanner;  //!< the old model's new name; empty: there was none
};

/// Writes the report, whatever the verdict. If the run passed, also writes the scanner model and
/// the camera. An old model is kept under the time it was written, scanner_20261122_031500.yaml,
/// and stays in place until the new one is complete.
/// @throw scan_cell_common::FileError if a file cannot be written; the old model is then still in
/// place
WrittenFiles save_calibration(const CalibrationRun& run, const CalibrationFiles& files);

}  // namespace scan_calibration
