// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/clusters.h"

namespace cloud_preprocess {

std::vector<KdTree::Index> cluster_of(const scan_cell_common::Cloud& points, const KdTree& tree,
                                      double gap, KdTree::Index start, std::vector<bool>& seen) {
  std::vector<std::pair<KdTree::Index, float>> near;
  seen[start] = true;
  std::vector<KdTree::Index> cluster{start};
  for (std::size_t next = 0; next < cluster.size(); ++next) {
    tree.within(points[cluster[next]].data, static_cast<float>(gap * gap), near);
    for (const auto& [point, squared] : near) {
      if (!seen[point]) cluster.push_back(point);
      seen[point] = true;
    }
  }
  return cluster;
}

std::vector<std::vector<KdTree::Index>> clusters(const scan_cell_common::Cloud& points,
                                                 double gap) {
  const KdTree tree(points);
  std::vector<bool> seen(points.size(), false);
  std::vector<std::vector<KdTree::Index>> found;
  for (KdTree::Index start = 0; start < points.size(); ++start)
    if (!seen[start]) found.push_back(cluster_of(points, tree, gap, start, seen));
  return found;
}

}  // namespace cloud_preprocess
