// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "thesis/registrations.h"

#include "geometry/kd_tree.h"
#include "geometry/points.h"

namespace tool_path_stretcher {

double ratio_of_principal_axes(const Points& reference, const Points& object) {
  return principal_frame(object).deviation[0] / principal_frame(reference).deviation[0];
}

Points nearest_points(const Points& at, const Points& object, const Similarity& registration) {
  const KdTree tree(object);
  Points result;
  result.reserve(at.size());
  for (const Eigen::Vector3d& point : at)
    result.push_back(object[tree.nearest(registration * point).index]);
  return result;
}

}  // namespace tool_path_stretcher
