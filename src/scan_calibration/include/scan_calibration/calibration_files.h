// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_calibration/calibration_run.h"
#include "scan_cell_common/scanner_model.h"

namespace scan_calibration {

/// Where the results of a calibration go.
struct CalibrationFiles {
  std::string scanner;      //!< scanner model, YAML
  std::string camera_info;  //!< the camera alone, as ROS' camera_info_manager reads it
  std::string report;       //!< JSON; its page and pictures go beside it, under the same stem
};

/// scanner.yaml -> scanner_camera_info.yaml
std::string camera_info_file(const std::string& scanner);

/// @throw scan_cell_common::FileError if a folder that results would go to is not there, or two
/// results would go to the same file
void check_writable(const CalibrationFiles& files);

/// Files that were written and kept.
struct WrittenFiles {
  std::string report;
  std::string page;          //!< HTML
  std::string scanner;       //!< empty: none was written
  std::string camera_info;   //!< empty: none was written
  std::string kept_scanner;  //!< the old one under its new name; empty: there was none
};

/// Writes the report, whatever the verdict; and where the run passed, the scanner model and the
/// camera. An old model is kept under the time it was written, scanner_20261122_031500.yaml, and
/// stays in its place until the new one is whole.
/// @throw scan_cell_common::FileError if one cannot be written; the old model is then in its place
WrittenFiles save_calibration(const CalibrationRun& run, const CalibrationFiles& files);

/// The report as JSON (docs/scan_calibration.md).
std::string report_json(const CalibrationRun& run, const WrittenFiles& written);

/// A picture of the report.
struct ReportPicture {
  std::string name;     //!< coverage, space_above, space_side, residuals, plane_laser_0
  std::string caption;  //!< what it shows and how to read it
  std::string png;      //!< its bytes
  std::string file;     //!< name, beside the page
};

/// Pictures of a calibration; only the coverage of the image where it was refused.
/// @param stem of their files' names
std::vector<ReportPicture> report_pictures(const CalibrationRun& run, const std::string& stem);

/// The report as a page for people.
std::string report_page(const CalibrationRun& run, const WrittenFiles& written,
                        const std::vector<ReportPicture>& pictures);

/// Writes a camera as camera_calibration_parsers reads it.
/// @throw scan_cell_common::FileError if it cannot be written
void save_camera_info(const std::string& path, const scan_cell_common::CameraIntrinsics& camera);

/// Copies a file beside itself under the time it was written.
/// @return the copy's path; empty where there is no file
/// @throw scan_cell_common::FileError if it cannot be copied
std::string keep_old(const std::string& path);

}  // namespace scan_calibration
