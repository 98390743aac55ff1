// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>

#include "tool_path_stretcher/points.h"

namespace tool_path_stretcher {
namespace {

struct PointsAdaptor {
  Points points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t index, std::size_t axis) const {
    return points[index][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointsAdaptor>,
                                        PointsAdaptor, 3, std::uint32_t>;

}  // namespace

struct KdTree::Index {
  explicit Index(Points points)
      : adaptor{std::move(points)},
        tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(10)) {}

  PointsAdaptor adaptor;
  Tree tree;
};

KdTree::KdTree(Points points) : index_(std::make_unique<Index>(std::move(points))) {}
KdTree::~KdTree() = default;
KdTree::KdTree(KdTree&&) noexcept = default;
KdTree& KdTree::operator=(KdTree&&) noexcept = default;

const Points& KdTree::points() const {
  return index_->adaptor.points;
}

KdTree::Neighbour KdTree::nearest(const Eigen::Vector3d& query) const {
  std::uint32_t index = 0;
  double squared_distance = 0;
  index_->tree.knnSearch(query.data(), 1, &index, &squared_distance);
  return {index, squared_distance};
}

KdTree::Clear KdTree::clearly_nearest(const Eigen::Vector3d& query) const {
  std::array<std::uint32_t, 2> indices{};
  std::array<double, 2> squares{};
  const std::size_t found = index_->tree.knnSearch(query.data(), 2, indices.data(), squares.data());
  if (found < 2) return {indices[0], std::numeric_limits<double>::infinity()};
  return {indices[0], std::sqrt(squares[1]) - std::sqrt(squares[0])};
}

void KdTree::nearest(const Eigen::Vector3d& query, std::size_t count,
                     std::vector<Neighbour>& found) const {
  std::vector<std::uint32_t> indices(count);
  std::vector<double> distances(count);
  const std::size_t got =
      index_->tree.knnSearch(query.data(), count, indices.data(), distances.data());
  found.clear();
  for (std::size_t i = 0; i < got; ++i)
    found.push_back({indices[i], distances[i]});
}

void KdTree::within(const Eigen::Vector3d& query, double radius,
                    std::vector<Neighbour>& found) const {
  std::vector<std::pair<std::uint32_t, double>> pairs;
  index_->tree.radiusSearch(query.data(), radius * radius, pairs,
                            nanoflann::SearchParams(32, 0, false));
  std::sort(pairs.begin(), pairs.end());
  found.clear();
  for (const auto& [index, squared_distance] : pairs)
    found.push_back({index, squared_distance});
}

}  // namespace tool_path_stretcher
