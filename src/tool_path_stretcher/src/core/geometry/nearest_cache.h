// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "geometry/kd_tree.h"

namespace tool_path_stretcher {

/// Nearest points of a tree for queries that move less and less from one round to the next: while a
/// query has moved by less than half of what its second nearest point was farther away, no other
/// point can have become the nearest, and the tree is not asked again. The second nearest is looked
/// for once that may be worth it.
class NearestCache {
 public:
  /// @param spacing of the tree's points [m]
  NearestCache(const KdTree& tree, std::size_t queries, double spacing)
      : tree_(&tree), spacing_(spacing), known_(queries) {}

  /// Index of the point of the tree that is nearest to where the query is now.
  std::size_t nearest(std::size_t query, const Eigen::Vector3d& at) {
    Known& known = known_[query];
    const double moved = (at - known.at).norm();
    if (moved < known.free) return known.index;
    if (!known.asked) {
      known = {at, tree_->nearest(at).index, 0, true};
    } else if (may_stay(known, at, moved)) {
      const KdTree::Clear found = tree_->clearly_nearest(at);
      known = {at, found.index, found.lead / 2, true};
    } else {
      known = {at, tree_->nearest_from(known.index, at).index, 0, true};
    }
    return known.index;
  }

 private:
  struct Known;

  /// Whether a query that has moved so far is likely to keep its nearest point the next time: the
  /// higher it is over the points, the less the second nearest is farther away.
  bool may_stay(const Known& known, const Eigen::Vector3d& at, double moved) const {
    constexpr double kLead = 0.25;  // of the spacing, of a query among the points; chosen
    const double off = (at - tree_->points()[known.index]).norm();
    return moved * std::max(off, spacing_) < kLead * spacing_ * spacing_;
  }

  struct Known {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    std::size_t index = 0;
    double free = 0;  // [m] that the query may move
    bool asked = false;
  };

  const KdTree* tree_;
  double spacing_;
  std::vector<Known> known_;
};

}  // namespace tool_path_stretcher
