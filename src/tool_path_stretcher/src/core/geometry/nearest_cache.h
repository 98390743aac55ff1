// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/kd_tree.h"

namespace tool_path_stretcher {

/// Nearest points of a tree for queries that move little from one round to the next: while a query
/// has moved by less than half of what its second nearest point was farther away, no other point
/// can have become the nearest, and the tree is not asked again.
class NearestCache {
 public:
  NearestCache(const KdTree& tree, std::size_t queries) : tree_(&tree), known_(queries) {}

  /// Index of the point of the tree that is nearest to where the query is now.
  std::size_t nearest(std::size_t query, const Eigen::Vector3d& at) {
    Known& known = known_[query];
    if ((at - known.at).squaredNorm() >= known.free * known.free) {
      const KdTree::Clear found = tree_->clearly_nearest(at);
      known = {at, found.index, found.lead / 2};
    }
    return known.index;
  }

 private:
  struct Known {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    std::size_t index = 0;
    double free = 0;  // [m] that the query may move
  };

  const KdTree* tree_;
  std::vector<Known> known_;
};

}  // namespace tool_path_stretcher
