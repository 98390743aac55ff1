// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict/ambiguity.h"

#include <algorithm>
#include <cmath>

#include "alignment/refinement.h"
#include "cores/by_index.h"
#include "geometry/kd_tree.h"
#include "geometry/points.h"
#include "geometry/robust.h"
#include "mapping/residuals.h"

namespace tool_path_stretcher {
namespace {

struct Laid {
  Points points;
  Points axes;  // of the tool
  std::vector<const Waypoint*> waypoints;
};

Laid laid(const ToolPath& path, const Mapping& mapping) {
  Laid result;
  for (const Segment& segment : path.segments) {
    for (const Waypoint& waypoint : segment.waypoints) {
      result.points.push_back(mapping * waypoint.pose.translation());
      result.axes.push_back(mapping.similarity.rotation * waypoint.pose.linear().col(2));
      result.waypoints.push_back(&waypoint);
    }
  }
  return result;
}

/// [m] from a point to the line between two others
double distance_to(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                   const Eigen::Vector3d& to) {
  const Eigen::Vector3d way = to - from;
  const double length = way.squaredNorm();
  const double at = length > 0 ? std::clamp(way.dot(point - from) / length, 0.0, 1.0) : 0.0;
  return (from + at * way - point).norm();
}

/// Whether each waypoint of `inner` lies on the line of `outer`.
bool lies_on(const Laid& inner, const Laid& outer, bool has_orientation, double tolerance) {
  constexpr double kSameAxis = 0.99;  // cosine: up to 8 degrees; chosen
  const KdTree tree(outer.points);
  for (std::size_t i = 0; i < inner.points.size(); ++i) {
    const std::size_t nearest = tree.nearest(inner.points[i]).index;
    double distance = (outer.points[nearest] - inner.points[i]).norm();
    if (nearest > 0) {
      distance = std::min(
          distance, distance_to(inner.points[i], outer.points[nearest - 1], outer.points[nearest]));
    }
    if (nearest + 1 < outer.points.size()) {
      distance = std::min(
          distance, distance_to(inner.points[i], outer.points[nearest], outer.points[nearest + 1]));
    }
    if (distance > tolerance) return false;
    if (has_orientation && inner.axes[i].dot(outer.axes[nearest]) < kSameAxis) return false;
    if (inner.waypoints[i]->process_values != outer.waypoints[nearest]->process_values) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool same_path(const ToolPath& path, const Mapping& one, const Mapping& other, double tolerance) {
  const Laid a = laid(path, one);
  const Laid b = laid(path, other);
  return lies_on(a, b, path.has_orientation, tolerance) &&
         lies_on(b, a, path.has_orientation, tolerance);
}

namespace {

/// [m] robust standard deviation of the scan from the mapped reference
double misfit(const SurfacePair& surfaces, const Mapping& mapping) {
  const Surface& object = surfaces.object;
  std::vector<double> distances;
  for (const Residual& residual :
       residuals_of(surfaces.reference, mapping, select(object.points, object.samples.few)))
    distances.push_back(mapping.similarity.scale * residual.along_normal);
  return robust_deviation(std::move(distances));
}

}  // namespace

std::vector<Mapping> slid_along_itself(const SurfacePair& surfaces, const Mapping& mapping,
                                       const ScalePrior& scale) {
  constexpr double kStep = 0.12;   // of the object's size; chosen
  constexpr double kBack = 0.05;   // of the object's size; less: it slid back; chosen
  constexpr double kHopeless = 5;  // times the misfit of the mapping; chosen
  constexpr int kIterations = 30;  // at most; chosen
  const double size = surfaces.object.size;
  const Points probes = select(surfaces.reference.points, surfaces.reference.samples.few);
  const double most = kHopeless * misfit(surfaces, mapping);
  const std::vector<Similarity> starts = slides(surfaces, mapping.similarity, kStep * size);
  return all_of<Mapping>(starts.size(), kSingly, [&](std::size_t i) -> std::optional<Mapping> {
    Similarity slid = starts[i];
    for (const Density density : {Density::kFew, Density::kMany}) {
      slid = refine(surfaces, slid, scale, density, kIterations);
      if (distance(slid, mapping.similarity, probes) < kBack * size) return {};
      if (misfit(surfaces, {slid, mapping.graph}) > most) return {};
    }
    return Mapping{slid, mapping.graph};
  });
}

std::vector<Mapping> slid_and_bent(const SurfacePair& surfaces, const Mapping& mapping,
                                   const ScalePrior& scale, int finest_level) {
  constexpr double kStep = 0.06;  // of the object's size; chosen
  const std::vector<Similarity> starts =
      slides(surfaces, mapping.similarity, kStep * surfaces.object.size);
  return by_index<Mapping>(starts.size(), kSingly, [&](std::size_t i) {
    return sketch_deformation(surfaces, starts[i], scale, finest_level);
  });
}

}  // namespace tool_path_stretcher
