// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

#include "tool_path_stretcher/similarity.h"

namespace tool_path_stretcher {

// The thesis' registrations as published, with PCL. Only what could not have worked is corrected;
// docs/tool_path_stretcher.md lists it. Both start from where the clouds lie, and neither refuses.

/// The ratio of the clouds' deviations along their principal axes (9.3), object to reference.
double ratio_of_principal_axes(const Points& reference, const Points& object);

/// The scales to try: scale (1 + range i / steps), i = -steps .. steps.
struct TriedScales {
  double scale = 1;    //!< object to reference
  double range = 0.1;  //!< 0.1 = +-10 % (r)
  int steps = 10;      //!< to each side (k)
};

/// The scale with the most inliers, and the pose that RANSAC found with it.
struct Consensus {
  Similarity similarity;    //!< reference to object
  std::size_t inliers = 0;  //!< of the object's points; 0: no pose was found at any scale
  bool at_bound = false;    //!< the scale is an end of the range
};

/// 9.4 to 9.6: RANSAC with PCL's registration model at each scale, with the clouds' centroids
/// aligned. The model needs pairs: each point of the object and the nearest of the reference.
/// @param inlier_distance [m, object]
/// @param progress 0 .. 1
Consensus register_by_consensus(const Points& reference, const Points& object,
                                const TriedScales& scales, double inlier_distance,
                                const std::function<void(double)>& progress);

/// 9.7, steps 3 to 5: PCL's ICP from the object, at the reference's size, to the reference.
/// @param scale object to reference
/// @return reference to object
Similarity register_by_icp(const Points& reference, const Points& object, double scale);

/// 9.7, steps 6 to 8: for each point of the reference, the object's nearest point after the
/// registration.
/// @param registration reference to object
Points nearest_points(const Points& at, const Points& object, const Similarity& registration);

}  // namespace tool_path_stretcher
