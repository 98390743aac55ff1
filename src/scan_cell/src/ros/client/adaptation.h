// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/CloudStatistics.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

#include "scan_cell/ros/cell_client.h"

namespace scan_cell {

/// The files that a path is adapted from, and where the results go.
struct AdaptationFiles {
  std::string reference;  //!< cloud of the reference part, PLY or PCD
  std::string path;       //!< tool path proven on it, CSV or YAML
  std::string output;     //!< folder for object.ply, adapted_path.csv and report.json
};

/// Names of the results in that folder.
std::vector<std::string> result_names();

/// Creates the folder and removes the results of an earlier run from it, so that they cannot be
/// taken for results of this run. Call it before anything else.
/// @throw scan_cell_common::FileError if a result would overwrite an input, or the folder cannot be
/// used
void clear_results(const AdaptationFiles& files);

/// Adapts the path to an object with the running stretcher and writes the results; a refusal leaves
/// no path.
/// @param scan of the object; the agreement of its passes goes into the report
/// @return the verdict
/// @throw scan_cell_common::Error if a file cannot be used or the stretcher is not there
scan_cell_msgs::StretchVerdict adapt(CellClient& client, const AdaptationFiles& files,
                                     const sensor_msgs::PointCloud2& object, double timeout,
                                     const CellClient::Progress& progress,
                                     const scan_cell_msgs::CloudStatistics& scan = {});

}  // namespace scan_cell
