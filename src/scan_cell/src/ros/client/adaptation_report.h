// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/CloudStatistics.h>

#include <string>

#include "client/adaptation.h"

namespace scan_cell {

/// What belongs to an adaptation in a running cell, besides the stretcher's result.
struct AdaptationRecord {
  AdaptationFiles files;
  std::string path_units;  //!< m, mm or inch
  std::string adapted;     //!< file; empty: refused
  std::string object;      //!< file
  double scanned = 0;      //!< [s] since 1970, of the object's cloud
  CalibrationFiles calibration;
};

/// The stretcher's report with the files, what the cell was calibrated with, and how the passes of
/// the scan agree. A calibration file that is not on this machine has no hash: null.
/// @throw scan_cell_common::FileError if one of the files of the adaptation cannot be read
std::string completed(const std::string& report, const AdaptationRecord& record,
                      const scan_cell_msgs::CloudStatistics& scan);

}  // namespace scan_cell
