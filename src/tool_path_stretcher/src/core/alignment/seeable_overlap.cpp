// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "alignment/seeable_overlap.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "geometry/points.h"
#include "sight/seeable.h"

namespace tool_path_stretcher {
namespace {

/// The common direction of the normals, ignoring their signs. Unit length.
Eigen::Vector3d mean_normal(const Surface& surface) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const std::size_t i : surface.samples.few)
    sum += surface.normals[i] * surface.normals[i].transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(2);
}

/// The possible sets of viewing directions of the object, in its frame.
std::vector<Points> possible_viewers(const Surface& object) {
  if (!object.seen_from.empty()) return {object.seen_from};
  const Eigen::Vector3d along = mean_normal(object);
  return {{along}, {-along}};
}

}  // namespace

double seeable_overlap(const SurfacePair& surfaces, const Mapping& mapping,
                       double inlier_distance) {
  double most = 0;
  const Eigen::Matrix3d to_reference = mapping.similarity.rotation.transpose();
  for (const Points& viewers : possible_viewers(surfaces.object)) {
    const Surface seeable = seeable_part(surfaces.reference, turned(viewers, to_reference));
    if (seeable.points.empty()) continue;
    most = std::max(most, explain({seeable, surfaces.object}, mapping, inlier_distance).overlap);
  }
  return most;
}

}  // namespace tool_path_stretcher
