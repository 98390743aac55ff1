// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nanoflann.hpp>
#include <vector>

#include "scan_cell_common/cloud_files.h"

namespace cloud_preprocess {

/// Nearest neighbours in a cloud, which must outlive it.
class KdTree {
 public:
  using Index = std::uint32_t;

  explicit KdTree(const scan_cell_common::Cloud& cloud)
      : source_{cloud}, tree_(3, source_, nanoflann::KDTreeSingleIndexAdaptorParams(16)) {}

  /// The nearest points, at most as many as `indices` and `squared` have room for; says how many.
  std::size_t nearest(const pcl::PointXYZ& point, std::vector<Index>& indices,
                      std::vector<float>& squared) const {
    return tree_.knnSearch(point.data, indices.size(), indices.data(), squared.data());
  }

  /// All points nearer than `radius` [m], in the tree's order.
  void within(const pcl::PointXYZ& point, double radius,
              std::vector<std::pair<Index, float>>& found) const {
    nanoflann::SearchParams unsorted;
    unsorted.sorted = false;
    tree_.radiusSearch(point.data, static_cast<float>(radius * radius), found, unsorted);
  }

 private:
  struct Source {
    const scan_cell_common::Cloud& cloud;

    std::size_t kdtree_get_point_count() const { return cloud.size(); }
    float kdtree_get_pt(std::size_t index, std::size_t axis) const {
      return cloud[index].data[axis];
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };

  Source source_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Source>, Source, 3, Index>
      tree_;
};

}  // namespace cloud_preprocess
