// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tool_path_stretcher {

using Points = std::vector<Eigen::Vector3d>;  //!< [m]

/// The mean of the points of each cell of a grid (thesis 8.5), in the order of the cells. Cells are
/// counted in 64 bits and sorted, so that neither the extent of the cloud nor the order in which a
/// hash table would hold them can change the result.
/// @param leaf edges of a cell [m], above 0
/// @throw scan_cell_common::InvalidParameter if a leaf is not above 0
/// @throw scan_cell_common::UnusableInput if a point is not finite or too far out to count its cell
Points reduce_on_grid(const Points& points, const Eigen::Vector3d& leaf);

/// Indices of at most `most` points, spread evenly over the space the points fill: one of each
/// cubic cell, whatever the density.
std::vector<std::size_t> spread_evenly(const Points& points, std::size_t most);

Points select(const Points& points, const std::vector<std::size_t>& indices);

/// Centroid, principal axes (columns, right-handed, longest first) and the standard deviation along
/// each [m].
struct PrincipalFrame {
  Eigen::Vector3d centroid;
  Eigen::Matrix3d axes;
  Eigen::Vector3d deviation;
};
PrincipalFrame principal_frame(const Points& points);

/// Nearest points of a fixed set, by a kd-tree.
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

  /// The nearest point, and how much farther [m] away the next one is (infinite: there is none).
  struct Clear {
    std::size_t index;
    double lead;
  };
  Clear clearly_nearest(const Eigen::Vector3d& query) const;

  /// The `count` nearest, nearest first; fewer where the set has fewer.
  void nearest(const Eigen::Vector3d& query, std::size_t count,
               std::vector<Neighbour>& found) const;

  /// All within `radius` [m], by index.
  void within(const Eigen::Vector3d& query, double radius, std::vector<Neighbour>& found) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace tool_path_stretcher
