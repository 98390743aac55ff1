// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tool_path_stretcher/similarity.h"
#include "tool_path_stretcher/stretch_parameters.h"
#include "tool_path_stretcher/tool_path.h"
#include "tool_path_stretcher/verdict.h"
#include "tool_path_stretcher/waypoint_quality.h"

namespace tool_path_stretcher {

/// The adapted path and its quality, or why there is none.
struct StretchResult {
  Verdict verdict;          //!< accepted, or the reason to refuse
  ToolPath path;            //!< on the object; empty unless accepted
  ToolPath reference_path;  //!< the same waypoints on the reference, to which `quality` refers;
                            //!< empty if the work did not get that far
  std::vector<WaypointQuality> quality;  //!< empty if the work did not get that far
  Method method = Method::kGeneral;      //!< method used
  bool aligned = false;     //!< false: similarity, deformation, rms and ratios are unknown
  Similarity similarity;    //!< reference to object
  Points mapped_reference;  //!< [m] up to 6000 reference points mapped onto the object, with its
                            //!< deformation; empty unless aligned
  std::size_t deformation_nodes = 0;  //!< of the graph; 0: no deformation was justified
  double rms = 0;                     //!< [m] object to aligned reference
  double inlier_ratio = 0;            //!< share of object points that the reference explains
  double overlap = 0;  //!< share of the reference's points that the object covers; of its visible
                       //!< points if the reference is closed or that share is too small
  double seconds = 0;  //!< of stretch() alone
  std::size_t reference_points = 0;  //!< after reduction
  std::size_t object_points = 0;     //!< after reduction
};

}  // namespace tool_path_stretcher
