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
  double overlap = 0;  //!< share of the reference's points that the object covers: of a closed
                       //!< one, or where that is too little, of those that can be seen
  double seconds = 0;  //!< of stretch() alone
  std::size_t reference_points = 0;  //!< after reduction
  std::size_t object_points = 0;     //!< after reduction
};

}  // namespace tool_path_stretcher
