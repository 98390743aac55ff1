// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <embree3/rtcore.h>

#include <Eigen/Core>
#include <limits>

namespace scan_cell_common {

/// Searches an Embree scene of triangles [m] for the one nearest to a point. Embree finds the
/// triangles in single precision; `measure` gives their distances. Users of this header must link
/// Embree.
/// @param measure called as measure(geometry, triangle) with their numbers; its result has the
/// member `distance` [m]
/// @return the result for the nearest triangle; its distance is infinite if there are no triangles
template <class Found, class Measure>
Found nearest_in_scene(RTCScene scene, const Eigen::Vector3d& point, const Measure& measure) {
  struct Search {
    const Measure& measure;
    Found best;
  } search{measure, {}};
  search.best.distance = std::numeric_limits<double>::infinity();

  RTCPointQuery query{};
  query.x = static_cast<float>(point.x());
  query.y = static_cast<float>(point.y());
  query.z = static_cast<float>(point.z());
  query.radius = std::numeric_limits<float>::infinity();
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  const auto look = [](RTCPointQueryFunctionArguments* arguments) {
    auto& s = *static_cast<Search*>(arguments->userPtr);
    const Found found = s.measure(arguments->geomID, arguments->primID);
    if (!(found.distance < s.best.distance)) return false;
    s.best = found;
    constexpr double kSinglePrecision = 1e-6;  // [m] includes triangles equally far; chosen
    arguments->query->radius = static_cast<float>(found.distance + kSinglePrecision);
    return true;
  };
  rtcPointQuery(scene, &query, &context, look, &search);
  return search.best;
}

}  // namespace scan_cell_common
