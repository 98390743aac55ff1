// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "tool_path_stretcher/similarity.h"

namespace tool_path_stretcher {

/// A set of points and its kd-tree.
class KdTree {
 public:
  struct Neighbour {
    std::size_t index;
    double squared_distance;  //!< [m^2]
  };

  explicit KdTree(Points points);
  ~KdTree();
  KdTree(KdTree&&) noexcept;
  KdTree& operator=(KdTree&&) noexcept;

  const Points& points() const;

  /// The set must not be empty.
  Neighbour nearest(const Eigen::Vector3d& query) const;

  /// The same but faster: `near_by` is the index of a point close to the nearest.
  Neighbour nearest_from(std::size_t near_by, const Eigen::Vector3d& query) const;

  /// The nearest point, and how much farther away [m] the second nearest is (infinite: there is
  /// none).
  struct Clear {
    std::size_t index;
    double lead;
  };
  Clear clearly_nearest(const Eigen::Vector3d& query) const;

  /// The `count` nearest points, nearest first; fewer if the set has fewer.
  void nearest(const Eigen::Vector3d& query, std::size_t count,
               std::vector<Neighbour>& found) const;

  /// All points within `radius` [m], ordered by index.
  void within(const Eigen::Vector3d& query, double radius, std::vector<Neighbour>& found) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace tool_path_stretcher
