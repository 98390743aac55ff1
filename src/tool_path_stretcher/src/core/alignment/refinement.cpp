// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "alignment/refinement.h"

#include <algorithm>
#include <cmath>

#include "alignment/refinement/motion_equations.h"
#include "alignment/refinement/pairing.h"
#include "alignment/refinement/weakest_motions.h"
#include "geometry/facing.h"
#include "geometry/points.h"
#include "mapping/residuals.h"

namespace tool_path_stretcher {

Similarity refine(const SurfacePair& surfaces, Similarity start, const ScalePrior& scale,
                  Density density, int iterations) {
  // [rad], of the object's size and of the scale, summed; chosen
  const double converged = density == Density::kMany ? 1e-6 : 3e-5;
  constexpr double kConverged = 0.01;    // of the residuals' deviation: the mean is known no better
  constexpr double kRimDeviation = 0.5;  // spacings: how far inside its rim a surface is sampled
  const Surface& object = surfaces.object;
  const Eigen::Vector3d centre = object.centroid;
  // Without noise, faces fit far better than sampled edges and holes. These must not become
  // outliers, since they may be all that shows a rotation.
  const double least = resolution(surfaces, start.scale);
  Pairing pairing(surfaces, density);
  const Eigen::Matrix3d axes = principal_frame(select(object.points, object.samples.few)).axes;
  const auto way_of = [](const PointConstraint& edge) -> const Eigen::Vector3d& {
    return edge.direction;
  };
  for (int i = 0; i < iterations; ++i) {
    const PointConstraints forth = pairing.object_to_reference(start);
    const PointConstraints back = pairing.reference_to_object(start);
    const PointConstraints edges = pairing.edge_to_edge(start);
    MotionEquations equations(centre);
    const double deviation = deviation_of(forth, least);
    equations.add(forth, deviation);
    equations.add(back, deviation_of(back, least));
    for (const PointConstraints& facing : by_facing(edges, axes, way_of))
      equations.add(facing, deviation_of(facing, kRimDeviation * object.spacing));
    equations.add_prior(scale, start.scale);
    const Vector7d step = equations.solve();
    start = moved(start, centre, step);
    const double motion =
        step.head<3>().norm() + step.segment<3>(3).norm() / object.size + std::abs(step[6]);
    if (motion < std::max(converged, kConverged * deviation / object.size)) break;
  }
  return start;
}

std::vector<Similarity> slides(const SurfacePair& surfaces, const Similarity& similarity,
                               double step) {
  const Eigen::Vector3d centre = surfaces.object.centroid;
  std::vector<Similarity> result;
  for (const Vector7d& motion : weakest_motions(surfaces, similarity, centre)) {
    result.push_back(moved(similarity, centre, step * motion));
    result.push_back(moved(similarity, centre, -step * motion));
  }
  return result;
}

std::vector<Axis> freest_axes(const SurfacePair& surfaces, const Similarity& similarity) {
  constexpr double kTurns = 0.7;  // of a unit motion: mostly a rotation, not a shift
  const Surface& object = surfaces.object;
  const Eigen::Vector3d centre = object.centroid;
  std::vector<Axis> axes;
  for (const Vector7d& motion : weakest_motions(surfaces, similarity, centre)) {
    const Eigen::Vector3d turn = motion.head<3>();
    if (turn.norm() * object.size < kTurns) continue;
    const Eigen::Vector3d shift = motion.segment<3>(3);
    axes.push_back({centre + turn.cross(shift) / turn.squaredNorm(), turn.normalized()});
  }
  return axes;
}

}  // namespace tool_path_stretcher
