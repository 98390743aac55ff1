// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/edges.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <utility>

#include "cores/by_index.h"
#include "geometry/kd_tree.h"

namespace tool_path_stretcher {
namespace {

constexpr std::size_t kNeighbours = 20;  // chosen: as for the rim

/// The two neighbours whose normals differ most, ignoring signs; none if they differ too little for
/// an edge.
std::optional<std::pair<std::size_t, std::size_t>> most_bent(
    const Surface& surface, const std::vector<KdTree::Neighbour>& neighbours) {
  constexpr double kBent = 0.8;  // cosine: an edge bends by more than 37 degrees; chosen
  double least = kBent;
  std::optional<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    for (std::size_t k = i + 1; k < neighbours.size(); ++k) {
      const double alike =
          std::abs(surface.normals[neighbours[i].index].dot(surface.normals[neighbours[k].index]));
      if (alike < least) {
        least = alike;
        found = {neighbours[i].index, neighbours[k].index};
      }
    }
  }
  return found;
}

/// The mean of the neighbours on a face; none if there are too few.
std::optional<Eigen::Vector3d> middle_of_face(const Surface& surface,
                                              const std::vector<KdTree::Neighbour>& neighbours,
                                              const Eigen::Vector3d& normal) {
  constexpr double kSameFace = 0.95;  // cosine: 18 degrees; chosen
  constexpr int kLeast = 3;           // points; chosen
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (const KdTree::Neighbour& neighbour : neighbours) {
    if (std::abs(surface.normals[neighbour.index].dot(normal)) < kSameFace) continue;
    sum += surface.points[neighbour.index];
    ++count;
  }
  if (count < kLeast) return {};
  return sum / count;
}

/// If a point lies on the edge of two faces: the outward direction of each face there.
std::vector<Eigen::Vector3d> outward_of_faces(const Surface& surface, std::size_t i) {
  constexpr double kOnFace = 0.7;  // spacings: distance of samples from their edge; chosen
  const Eigen::Vector3d& point = surface.points[i];
  std::vector<KdTree::Neighbour> neighbours;
  surface.tree->nearest(point, kNeighbours, neighbours);
  const auto bent = most_bent(surface, neighbours);
  if (!bent) return {};
  std::vector<Eigen::Vector3d> outward;
  const Eigen::Vector3d normals[] = {surface.normals[bent->first], surface.normals[bent->second]};
  const Eigen::Vector3d along = normals[0].cross(normals[1]).normalized();
  for (const Eigen::Vector3d& normal : normals) {
    const auto middle = middle_of_face(surface, neighbours, normal);
    if (!middle || std::abs(normal.dot(point - *middle)) > kOnFace * surface.spacing) return {};
    const Eigen::Vector3d across = along.cross(normal);
    outward.push_back(across.dot(point - *middle) < 0 ? Eigen::Vector3d(-across) : across);
  }
  return outward;
}

}  // namespace

Rim edges_of(const Surface& surface) {
  Rim edges = surface.rim;
  const auto outward = by_index<std::vector<Eigen::Vector3d>>(
      surface.points.size(), kHundreds,
      [&](std::size_t i) { return outward_of_faces(surface, i); });
  for (std::size_t i = 0; i < outward.size(); ++i) {
    for (const Eigen::Vector3d& way : outward[i]) {
      edges.points.push_back(surface.points[i]);
      edges.outward.push_back(way);
      edges.open.push_back(false);
      edges.horizon.push_back(false);
    }
  }
  if (!edges.points.empty()) edges.tree = std::make_shared<const KdTree>(edges.points);
  return edges;
}

std::optional<std::size_t> edge_facing(const Rim& edges, const Eigen::Vector3d& at,
                                       const Eigen::Vector3d& outward) {
  constexpr std::size_t kLookedAt = 6;  // at a corner three faces end, each twice; chosen
  constexpr double kFacesAlike = 0.7;   // cosine: up to 46 degrees; chosen
  std::vector<KdTree::Neighbour> neighbours;
  edges.tree->nearest(at, kLookedAt, neighbours);
  for (const KdTree::Neighbour& neighbour : neighbours) {
    if (edges.outward[neighbour.index].dot(outward) >= kFacesAlike) return neighbour.index;
  }
  return {};
}

}  // namespace tool_path_stretcher
