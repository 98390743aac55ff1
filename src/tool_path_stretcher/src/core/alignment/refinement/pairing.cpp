// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "alignment/refinement/pairing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "cores/by_index.h"
#include "geometry/facing.h"
#include "geometry/points.h"
#include "geometry/robust.h"
#include "surface/edges.h"

namespace tool_path_stretcher {
namespace {

/// The distance from a mapped reference point to an object point along the first normal. None
/// unless the two may be the same place: close to each other laterally, on surfaces that face
/// alike.
std::optional<PointConstraint> pair_of(const Eigen::Vector3d& mapped, const Eigen::Vector3d& object,
                                       const Eigen::Vector3d& normal,
                                       const Eigen::Vector3d& other_normal, double spacing) {
  constexpr double kReach = 4;         // spacings; chosen
  constexpr double kFacesAlike = 0.7;  // cosine: up to 46 degrees; chosen
  if (std::abs(normal.dot(other_normal)) < kFacesAlike) return {};
  const Eigen::Vector3d way = object - mapped;
  const double along = normal.dot(way);
  const double beside = (way - along * normal).norm();
  if (beside >= kReach * spacing) return {};
  return PointConstraint{mapped, normal, along};
}

}  // namespace

Pairing::Pairing(const SurfacePair& surfaces, Density density)
    : reference_(surfaces.reference),
      object_(surfaces.object),
      object_sample_(object_.samples.of(density)),
      reference_sample_(reference_.samples.of(density)),
      in_reference_(*reference_.tree, object_sample_.size(), reference_.spacing),
      in_object_(*object_.tree, reference_sample_.size(), object_.spacing) {
  if (!reference_.edges.tree) return;
  constexpr std::size_t kEdgeShare = 3;  // one part of the sample; chosen
  edge_sample_ = spread_evenly(object_.edges.points, object_sample_.size() / kEdgeShare);
}

PointConstraints Pairing::object_to_reference(const Similarity& similarity) {
  return all_of<PointConstraint>(object_sample_.size(), kHundreds, [&](std::size_t k) {
    const std::size_t i = object_sample_[k];
    const std::size_t nearest = in_reference_.nearest(k, similarity.inverse(object_.points[i]));
    return pair_of(similarity * reference_.points[nearest], object_.points[i],
                   similarity.rotation * reference_.normals[nearest], object_.normals[i],
                   similarity.scale * reference_.spacing);
  });
}

PointConstraints Pairing::reference_to_object(const Similarity& similarity) {
  return all_of<PointConstraint>(reference_sample_.size(), kHundreds, [&](std::size_t k) {
    const std::size_t i = reference_sample_[k];
    const Eigen::Vector3d mapped = similarity * reference_.points[i];
    const std::size_t nearest = in_object_.nearest(k, mapped);
    return pair_of(mapped, object_.points[nearest], object_.normals[nearest],
                   similarity.rotation * reference_.normals[i], object_.spacing);
  });
}

PointConstraints Pairing::edge_to_edge(const Similarity& similarity) const {
  constexpr double kReach = 0.08;  // of the object's size; chosen
  const Rim& edges = reference_.edges;
  return all_of<PointConstraint>(
      edge_sample_.size(), kHundreds, [&](std::size_t k) -> std::optional<PointConstraint> {
        const std::size_t i = edge_sample_[k];
        const Eigen::Vector3d& point = object_.edges.points[i];
        const Eigen::Vector3d facing = similarity.rotation.transpose() * object_.edges.outward[i];
        const auto nearest = edge_facing(edges, similarity.inverse(point), facing);
        if (!nearest || edges.horizon[*nearest]) return {};
        const Eigen::Vector3d mapped = similarity * edges.points[*nearest];
        if ((point - mapped).norm() > kReach * object_.size) return {};
        const Eigen::Vector3d outward = similarity.rotation * edges.outward[*nearest];
        return PointConstraint{mapped, outward, outward.dot(point - mapped)};
      });
}

double deviation_of(const PointConstraints& constraints, double least) {
  std::vector<double> errors;
  errors.reserve(constraints.size());
  for (const PointConstraint& constraint : constraints)
    errors.push_back(constraint.error);
  return std::max(robust_deviation(std::move(errors)), least);
}

}  // namespace tool_path_stretcher
