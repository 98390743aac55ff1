// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scan_calibration/calibration_files.h"

namespace scan_calibration {

/// A picture of the report.
struct ReportPicture {
  std::string name;     //!< coverage, space_above, space_side, residuals, plane_laser_0
  std::string caption;  //!< what it shows and how to read it
  std::string svg;
};

/// Pictures of a calibration; if it was refused, only the coverage of the image.
std::vector<ReportPicture> report_pictures(const CalibrationRun& run);

/// The report as a page for people.
std::string report_page(const CalibrationRun& run, const WrittenFiles& written);

/// The report as JSON (docs/scan_calibration.md).
std::string report_json(const CalibrationRun& run, const WrittenFiles& written);

/// The observations by the names of their views.
using ViewsByName = std::map<std::string, const ViewObservation*>;
ViewsByName by_name(const Observations& observations);

}  // namespace scan_calibration
