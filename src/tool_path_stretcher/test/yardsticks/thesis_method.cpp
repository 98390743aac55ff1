// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "yardsticks/thesis_method.h"

#include "thesis/registrations.h"

namespace cases {

ToolPath thesis_method(const Points& reference, const Points& object, const ToolPath& path) {
  using namespace tool_path_stretcher;
  const Similarity registration =
      register_by_icp(reference, object, ratio_of_principal_axes(reference, object));
  ToolPath result = path;
  for (Segment& segment : result.segments) {
    const Points nearest = nearest_points(positions_of(segment), object, registration);
    for (std::size_t i = 0; i < nearest.size(); ++i)
      segment.waypoints[i].pose.translation() = nearest[i];
  }
  return result;
}

}  // namespace cases
