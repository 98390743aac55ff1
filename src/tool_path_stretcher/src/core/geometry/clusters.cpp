// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/clusters.h"

#include <algorithm>

namespace tool_path_stretcher {

std::vector<std::vector<std::size_t>> clusters(
    const KdTree& tree, double gap, const std::function<bool(std::size_t, std::size_t)>& linked) {
  const Points& points = tree.points();
  std::vector<bool> seen(points.size(), false);
  std::vector<KdTree::Neighbour> near;
  std::vector<std::vector<std::size_t>> found;
  for (std::size_t start = 0; start < points.size(); ++start) {
    if (seen[start]) continue;
    seen[start] = true;
    std::vector<std::size_t> cluster{start};
    for (std::size_t next = 0; next < cluster.size(); ++next) {
      tree.within(points[cluster[next]], gap, near);
      for (const KdTree::Neighbour& neighbour : near) {
        if (seen[neighbour.index] || (linked && !linked(cluster[next], neighbour.index))) continue;
        seen[neighbour.index] = true;
        cluster.push_back(neighbour.index);
      }
    }
    found.push_back(std::move(cluster));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& one, const auto& other) { return one.size() > other.size(); });
  return found;
}

}  // namespace tool_path_stretcher
