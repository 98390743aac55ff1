// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/CloudStatistics.h>

#include <string>

#include "scan_cell/ros/cell_client.h"

namespace scan_cell {

/// Data about an adaptation in a running cell, besides the stretcher's result.
struct AdaptationRecord {
  std::string reference;         //!< file
  std::string path;              //!< file, proven on the reference
  std::string path_units;        //!< m, mm or inch; of both paths
  std::string object;            //!< file
  std::string adapted;           //!< file; empty: refused
  double scanned = 0;            //!< [s] since 1970, of the object's cloud
  CalibrationFiles calibration;  //!< of the cell
};

/// The stretcher's report, completed with the files, the cell's calibration, and how the passes of
/// the scan agree. A calibration file that is not on this machine has the hash null.
/// @throw scan_cell_common::FileError if one of the files of the adaptation cannot be read
std::string completed(const std::string& report, const AdaptationRecord& record,
                      const scan_cell_msgs::CloudStatistics& scan);

}  // namespace scan_cell
