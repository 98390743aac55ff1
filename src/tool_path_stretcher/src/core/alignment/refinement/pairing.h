// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "geometry/nearest_cache.h"
#include "surface/surface_pair.h"

namespace tool_path_stretcher {

/// A point of the mapped reference that should move by `error` along `direction`, in the object's
/// frame.
struct PointConstraint {
  Eigen::Vector3d point;
  Eigen::Vector3d direction;  // unit length
  double error;               // [m]
};
using PointConstraints = std::vector<PointConstraint>;

/// Pairs the points of two surfaces in both directions while one moves towards the other.
class Pairing {
 public:
  Pairing(const SurfacePair& surfaces, Density density);

  PointConstraints object_to_reference(const Similarity& similarity);

  PointConstraints reference_to_object(const Similarity& similarity);

  /// The object's edges should lie on the reference's, but may slide along them.
  PointConstraints edge_to_edge(const Similarity& similarity) const;

 private:
  const Surface& reference_;
  const Surface& object_;
  const std::vector<std::size_t>& object_sample_;
  const std::vector<std::size_t>& reference_sample_;
  std::vector<std::size_t> edge_sample_;  // of the object; empty if the reference has no edge
  NearestCache in_reference_;
  NearestCache in_object_;
};

/// Robust standard deviation of the errors [m], not below `least`.
double deviation_of(const PointConstraints& constraints, double least);

}  // namespace tool_path_stretcher
