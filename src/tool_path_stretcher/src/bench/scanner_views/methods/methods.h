// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scanner_views/view_case.h"
#include "tool_path_stretcher/stretcher.h"

namespace scanner_views {

/// Verdict of a yardstick whose program is not there.
constexpr const char* kNotInstalled = "not installed";

/// What a method made of a view.
struct Answer {
  bool accepted = false;
  std::string verdict;                                        //!< in its own words
  std::string message;                                        //!< why it refused
  ToolPath path;                                              //!< on the object
  std::vector<tool_path_stretcher::WaypointQuality> quality;  //!< only ours
  double seconds = 0;                                         //!< of the processor
};

/// What the yardsticks are given: both surfaces on the default grid, as the suite reduces them.
struct Reduced {
  Points reference;  //!< [m]
  Points object;     //!< [m]
};
Reduced reduced(const View& view);

/// The suite's, with default parameters.
Answer run_ours(const View& view);

/// The thesis' general method, which never refuses.
Answer run_thesis(const View& view);

/// PCL's FPFH, prerejective RANSAC and ICP with scale; accepted: both say that they converged.
Answer run_pcl(const View& view);

/// Open3D's FPFH, RANSAC and ICP with scale (open3d_registration.py); accepted: ICP's fitness is
/// above 0.
/// @return the verdict "not installed" where python3-open3d is not
Answer run_open3d(const View& view);

}  // namespace scanner_views
