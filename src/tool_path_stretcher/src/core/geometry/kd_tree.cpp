// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/kd_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scan_cell_common/geometry/point_tree.h"

namespace tool_path_stretcher {
namespace {

constexpr std::size_t kLeafSize = 10;  // points; nanoflann's default

}  // namespace

struct KdTree::Index {
  explicit Index(Points given) : points(std::move(given)), tree(points, kLeafSize) {}

  Points points;
  scan_cell_common::PointTree tree;
};

KdTree::KdTree(Points points) : index_(std::make_unique<Index>(std::move(points))) {}
KdTree::~KdTree() = default;
KdTree::KdTree(KdTree&&) noexcept = default;
KdTree& KdTree::operator=(KdTree&&) noexcept = default;

const Points& KdTree::points() const {
  return index_->points;
}

KdTree::Neighbour KdTree::nearest(const Eigen::Vector3d& query) const {
  std::uint32_t index = 0;
  double squared_distance = std::numeric_limits<double>::max();
  index_->tree.nearest_within(query.data(), index, squared_distance);
  return {index, squared_distance};
}

KdTree::Neighbour KdTree::nearest_from(std::size_t near_by, const Eigen::Vector3d& query) const {
  constexpr double kRounding = 1e-12;  // finds the nearby point again, and resolves ties alike
  double squared_distance = (query - index_->points[near_by]).squaredNorm() * (1 + kRounding) +
                            std::numeric_limits<double>::min();
  auto index = static_cast<std::uint32_t>(near_by);
  index_->tree.nearest_within(query.data(), index, squared_distance);
  return {index, squared_distance};
}

KdTree::Clear KdTree::clearly_nearest(const Eigen::Vector3d& query) const {
  std::array<std::uint32_t, 2> indices{};
  std::array<double, 2> squares{};
  const std::size_t found = index_->tree.nearest(query.data(), 2, indices.data(), squares.data());
  if (found < 2) return {indices[0], std::numeric_limits<double>::infinity()};
  return {indices[0], std::sqrt(squares[1]) - std::sqrt(squares[0])};
}

void KdTree::nearest(const Eigen::Vector3d& query, std::size_t count,
                     std::vector<Neighbour>& found) const {
  std::vector<std::uint32_t> indices(count);
  std::vector<double> distances(count);
  const std::size_t got =
      index_->tree.nearest(query.data(), count, indices.data(), distances.data());
  found.clear();
  for (std::size_t i = 0; i < got; ++i)
    found.push_back({indices[i], distances[i]});
}

void KdTree::within(const Eigen::Vector3d& query, double radius,
                    std::vector<Neighbour>& found) const {
  std::vector<std::pair<std::uint32_t, double>> pairs;
  index_->tree.within(query.data(), radius * radius, pairs);
  std::sort(pairs.begin(), pairs.end());
  found.clear();
  for (const auto& [index, squared_distance] : pairs)
    found.push_back({index, squared_distance});
}

}  // namespace tool_path_stretcher
