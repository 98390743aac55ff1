// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "geometry/kd_tree.h"

namespace tool_path_stretcher {

/// Nearest points of a tree for queries that move less and less from round to round. The lead is
/// how much farther away the second nearest point is. Until a query has moved by half of it, no
/// other point can have become the nearest, and the tree is not queried again. The second nearest
/// is looked up only when that may pay off.
class NearestCache {
 public:
  /// @param spacing of the tree's points [m]
  NearestCache(const KdTree& tree, std::size_t queries, double spacing)
      : tree_(&tree), spacing_(spacing), known_(queries) {}

  /// Index of the tree's point nearest to the query's current position.
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

  /// Whether a query that has moved by `moved` is likely to keep its nearest point next time. The
  /// farther the query is from the points, the smaller the lead of the nearest one.
  bool may_stay(const Known& known, const Eigen::Vector3d& at, double moved) const {
    constexpr double kLead = 0.25;  // of the spacing, for a query among the points; chosen
    const double off = (at - tree_->points()[known.index]).norm();
    return moved * std::max(off, spacing_) < kLead * spacing_ * spacing_;
  }

  struct Known {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    std::size_t index = 0;
    double free = 0;  // [m] the query may still move
    bool asked = false;
  };

  const KdTree* tree_;
  double spacing_;
  std::vector<Known> known_;
};

}  // namespace tool_path_stretcher
