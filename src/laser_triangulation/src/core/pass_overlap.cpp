// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_overlap.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "scan_cell_common/geometry/kd_tree.h"

namespace laser_triangulation {
namespace {

using Points = std::vector<Eigen::Vector3f>;

struct Coordinate {
  float operator()(const Eigen::Vector3f& point, std::size_t axis) const {
    return point[static_cast<Eigen::Index>(axis)];
  }
};
using KdTree = scan_cell_common::KdTree<Points, Coordinate, float>;

constexpr std::size_t kMaxInTree = 500'000;   // points of a sweep; chosen: a second to build
constexpr std::size_t kMaxCompared = 20'000;  // points of a pair; chosen: 95 % known to 0.2 %
constexpr std::size_t kMinCompared = 100;     // fewer say nothing; chosen
constexpr std::size_t kNeighbours = 24;       // several profiles of a dense scan; chosen
constexpr float kReach = 2e-3F;               // [m] to the nearest neighbour; chosen
constexpr float kMaxRoughness = 1e-4F;        // [m] RMS of a patch that is no edge; chosen
constexpr float kMinBreadth = 1e-4F;          // [m] RMS across a patch that is no line; chosen

std::map<std::pair<std::uint8_t, std::uint8_t>, Points> sweeps_of(const ScanCloud& cloud) {
  std::map<std::pair<std::uint8_t, std::uint8_t>, Points> sweeps;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const ScanPoint& point = cloud[i];
    sweeps[{point.pass, point.laser}].emplace_back(point.x, point.y, point.z);
  }
  return sweeps;
}

/// Every n-th point, so that at most so many are left.
Points thinned(const Points& points, std::size_t most) {
  const std::size_t step = std::max<std::size_t>(1, (points.size() + most - 1) / most);
  Points result;
  for (std::size_t i = 0; i < points.size(); i += step)
    result.push_back(points[i]);
  return result;
}

/// [m] of a point from the flat patch of its neighbours; none where there is no such patch.
std::optional<float> distance_to_surface(const Eigen::Vector3f& point, const KdTree& tree,
                                         const Points& surface) {
  std::array<KdTree::Index, kNeighbours> indices{};
  std::array<float, kNeighbours> squared{};
  const std::size_t found = tree.nearest(point.data(), kNeighbours, indices.data(), squared.data());
  if (found < kNeighbours || squared[0] > kReach * kReach) return std::nullopt;
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const KdTree::Index index : indices)
    mean += surface[index] / static_cast<float>(kNeighbours);
  Eigen::Matrix3f scatter = Eigen::Matrix3f::Zero();
  for (const KdTree::Index index : indices) {
    const Eigen::Vector3f off = surface[index] - mean;
    scatter += off * off.transpose() / static_cast<float>(kNeighbours);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes(scatter);
  if (axes.eigenvalues()[0] > kMaxRoughness * kMaxRoughness) return std::nullopt;
  if (axes.eigenvalues()[1] < kMinBreadth * kMinBreadth) return std::nullopt;
  return std::abs(axes.eigenvectors().col(0).dot(point - mean));
}

/// The value below which this share of them is.
float quantile(std::vector<float>& values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

std::vector<PassOverlap> compare_sweeps(const ScanCloud& cloud) {
  const auto sweeps = sweeps_of(cloud);
  std::vector<PassOverlap> overlaps;
  for (auto one = sweeps.begin(); one != sweeps.end(); ++one) {
    if (std::next(one) == sweeps.end()) break;  // a tree for nobody
    const Points surface = thinned(one->second, kMaxInTree);
    const KdTree tree(surface);
    for (auto other = std::next(one); other != sweeps.end(); ++other) {
      std::vector<float> distances;
      for (const Eigen::Vector3f& point : thinned(other->second, kMaxCompared)) {
        const auto distance = distance_to_surface(point, tree, surface);
        if (distance) distances.push_back(*distance);
      }
      if (distances.size() < kMinCompared) continue;
      overlaps.push_back({{one->first.first, one->first.second},
                          {other->first.first, other->first.second},
                          distances.size(),
                          static_cast<double>(quantile(distances, 0.5)),
                          static_cast<double>(quantile(distances, 0.95))});
    }
  }
  return overlaps;
}

}  // namespace laser_triangulation
