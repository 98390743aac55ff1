// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tool_path_stretcher/similarity.h"
#include "tool_path_stretcher/stretch_parameters.h"
#include "tool_path_stretcher/surface.h"
#include "tool_path_stretcher/tool_path.h"
#include "tool_path_stretcher/verdict.h"
#include "tool_path_stretcher/waypoint_quality.h"

namespace tool_path_stretcher {

/// Called as the work goes on, with the stage and the progress of the whole (0 .. 1). Returns false
/// to cancel.
using Progress = std::function<bool(const std::string& stage, double progress)>;

/// The adapted path and what is known of it, or why there is none.
struct StretchResult {
  Verdict verdict;          //!< accepted, or the reason to refuse
  ToolPath path;            //!< on the object; empty unless accepted
  ToolPath reference_path;  //!< the same waypoints on the reference, those that
                            //!< `quality` is about; empty where it did not come to that
  std::vector<WaypointQuality> quality;  //!< empty where it did not come to that
  Method method = Method::kGeneral;      //!< that was used
  bool aligned = false;     //!< false: similarity, deformation, rms and ratios are not known
  Similarity similarity;    //!< reference to object
  Points mapped_reference;  //!< [m] up to 6000 points of the reference as they come to lie on the
                            //!< object, deformed as it is; empty unless aligned
  std::size_t deformation_nodes = 0;  //!< of the graph that was justified; 0: none
  double rms = 0;                     //!< [m] object to aligned reference
  double inlier_ratio = 0;            //!< share of object points that the reference explains
  double overlap = 0;                 //!< share of reference points that the object covers
  double seconds = 0;                 //!< of stretch() alone
  std::size_t reference_points = 0;   //!< after reduction
  std::size_t object_points = 0;      //!< after reduction
};

/// Adapts a path on the reference to the object, or refuses with a reason. The same input gives the
/// same path, bit for bit.
/// @throw scan_cell_common::InvalidParameter if the parameters make no sense; all else is a verdict
StretchResult stretch(const Surface& reference, const Surface& object, const ToolPath& path,
                      const StretchParameters& parameters, const Progress& progress = {});

}  // namespace tool_path_stretcher
