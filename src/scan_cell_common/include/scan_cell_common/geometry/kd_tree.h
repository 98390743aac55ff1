// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nanoflann.hpp>
#include <utility>
#include <vector>

namespace scan_cell_common {

/// A kd-tree over a list of points, for nearest-neighbour queries. All lengths are in the points'
/// unit.
/// @tparam Points a list with size() and operator[]
/// @tparam Coordinate a function object (point, axis) -> Scalar
template <class Points, class Coordinate, class Scalar>
class KdTree {
 public:
  using Index = std::uint32_t;  //!< of a point

  /// @param points must outlive the tree and not move in memory
  /// @param leaf_size points per leaf; affects the speed and the order of ties
  explicit KdTree(const Points& points, std::size_t leaf_size = 16)
      : source_{points}, tree_(3, source_, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size)) {}
  KdTree(const KdTree&) = delete;  // nanoflann's tree refers to its points
  KdTree& operator=(const KdTree&) = delete;

  /// The `count` nearest points, nearest first.
  /// @param query three coordinates
  /// @return how many were found: fewer if the list is shorter
  std::size_t nearest(const Scalar* query, std::size_t count, Index* indices,
                      Scalar* squared_distances) const {
    return tree_.knnSearch(query, count, indices, squared_distances);
  }

  /// The nearest point within a given distance: a known bound makes the search shorter.
  /// @param index,squared_distance in: the squared bound; out: the point; unchanged if there is
  /// none
  void nearest_within(const Scalar* query, Index& index, Scalar& squared_distance) const {
    Nearest nearest{index, squared_distance};
    tree_.findNeighbors(nearest, query, nanoflann::SearchParams());
  }

  /// All points closer than the root of `squared_radius`, with their squared distances, in the
  /// tree's order.
  void within(const Scalar* query, Scalar squared_radius,
              std::vector<std::pair<Index, Scalar>>& found) const {
    nanoflann::SearchParams unsorted;
    unsorted.sorted = false;
    tree_.radiusSearch(query, squared_radius, found, unsorted);
  }

 private:
  /// Result set for nanoflann. Its own set of one point does more work per point.
  struct Nearest {
    Index& index;
    Scalar& squared_distance;

    Scalar worstDist() const { return squared_distance; }
    bool full() const { return true; }
    bool addPoint(Scalar distance, Index point) {
      if (distance < squared_distance) {
        squared_distance = distance;
        index = point;
      }
      return true;
    }
  };

  struct Source {
    const Points& points;

    std::size_t kdtree_get_point_count() const { return points.size(); }
    Scalar kdtree_get_pt(std::size_t index, std::size_t axis) const {
      return Coordinate()(points[index], axis);
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };

  Source source_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<Scalar, Source>, Source, 3,
                                      Index>
      tree_;
};

}  // namespace scan_cell_common
