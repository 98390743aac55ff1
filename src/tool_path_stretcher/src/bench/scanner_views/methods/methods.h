// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scanner_views/view_case.h"
#include "tool_path_stretcher/stretcher.h"

namespace scanner_views {

/// Verdict of a yardstick whose program is not installed.
constexpr const char* kNotInstalled = "not installed";

/// A method's result for a view.
struct Answer {
  bool accepted = false;
  std::string verdict;                                        //!< in the method's own words
  std::string message;                                        //!< why it refused
  ToolPath path;                                              //!< on the object
  std::vector<tool_path_stretcher::WaypointQuality> quality;  //!< ours only
  double seconds = 0;                                         //!< processor time
};

/// Input of the yardsticks: both surfaces on the default grid, reduced as in the suite.
struct Reduced {
  Points reference;  //!< [m]
  Points object;     //!< [m]
};
Reduced reduced(const View& view);

/// The suite with default parameters.
Answer run_ours(const View& view);

/// The thesis' general method, which never refuses.
Answer run_thesis(const View& view);

/// PCL's FPFH, prerejective RANSAC and ICP with scale; accepted if both report convergence.
Answer run_pcl(const View& view);

/// Open3D's FPFH, RANSAC and ICP with scale (open3d_registration.py); accepted if ICP's fitness is
/// above 0.
/// @return the verdict "not installed" if python3-open3d is missing
Answer run_open3d(const View& view);

}  // namespace scanner_views
