// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "thesis/thesis_fit.h"

#include <fmt/format.h>

#include <cmath>

#include "geometry/points.h"
#include "thesis/registrations.h"
#include "verdict/checks.h"

namespace tool_path_stretcher {
namespace {

Similarity by_consensus(const Points& reference, const Points& object, double scale,
                        const StretchParameters& parameters, const AlignmentProgress& progress) {
  const Consensus consensus = register_by_consensus(
      reference, object, {scale, parameters.scale_range, parameters.scale_steps},
      parameters.inlier_distance, progress);
  if (consensus.inliers == 0) refuse_wrong_part("RANSAC found no pose of the reference that fits");
  if (consensus.at_bound && !parameters.prior.scale.is_fixed())
    refuse_search_at_bound(consensus.similarity.scale, parameters);
  return consensus.similarity;
}

}  // namespace

bool is_thesis(Method method) {
  return method == Method::kThesisAffine || method == Method::kThesisGeneral;
}

Similarity register_as_thesis(const SurfacePair& surfaces, const StretchParameters& parameters,
                              const AlignmentProgress& progress) {
  const Prior& prior = parameters.prior;
  const Eigen::Isometry3d start = prior.pose ? prior.pose->pose : Eigen::Isometry3d::Identity();
  Points reference;
  for (const Eigen::Vector3d& point : surfaces.reference.points)
    reference.push_back(start * point);
  const Points& object = surfaces.object.points;
  const double scale =
      prior.scale.is_known() ? prior.scale.value : ratio_of_principal_axes(reference, object);
  Similarity found = parameters.method == Method::kThesisAffine
                         ? by_consensus(reference, select(object, surfaces.object.samples.many),
                                        scale, parameters, progress)
                         : register_by_icp(reference, object, scale);
  found.translation = found * start.translation();
  found.rotation = found.rotation * start.linear();
  return found;
}

void check_registration(const SurfacePair& surfaces, const Fitted& registered,
                        const std::vector<Fitted>& searched) {
  for (const Fitted& other : searched) {
    if (is_same_pose(registered.mapping.similarity, other.mapping.similarity, surfaces.reference) ||
        !clearly_better(other.explanation, registered.explanation))
      continue;
    refuse(Reason::kAmbiguous, "pose",
           fmt::format("where the registration ended, the reference explains {:.4g} % of the "
                       "object, and elsewhere it explains {:.4g} %",
                       100 * registered.explanation.inlier_ratio,
                       100 * other.explanation.inlier_ratio),
           "say where the part lies (initial_pose), or use the general method");
  }
}

void move_to_nearest_points(const ToolPath& path, const SurfacePair& surfaces,
                            const Mapping& mapping, Placement& placement) {
  std::size_t at = 0;
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const Points waypoints = positions_of(path.segments[s]);
    const Points nearest = nearest_points(waypoints, surfaces.object.points, mapping.similarity);
    for (std::size_t w = 0; w < nearest.size(); ++w, ++at) {
      if (placement.quality[at].in_air) continue;
      const Eigen::Vector3d moved = nearest[w] - mapping * waypoints[w];
      placement.path.segments[s].waypoints[w].pose.translation() = nearest[w];
      placement.quality[at].distance_to_scan = 0;
      placement.quality[at].displacement = moved.norm();
      placement.heights[at].applied = moved.dot(placement.heights[at].normal);
    }
  }
}

void expect_sampling_errors(double spacing, Placement& placement) {
  // In each direction the nearest point of a square grid is evenly distributed within half a step.
  const double deviation = spacing / std::sqrt(6.0);
  for (WaypointQuality& quality : placement.quality) {
    quality.expected_error_tangential = std::hypot(quality.expected_error_tangential, deviation);
    quality.expected_error_across =
        std::hypot(quality.expected_error_across, deviation / std::sqrt(2.0));
  }
}

}  // namespace tool_path_stretcher
