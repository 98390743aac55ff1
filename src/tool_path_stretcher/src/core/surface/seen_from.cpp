// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/seen_from.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <vector>

#include "scan_cell_common/clouds/fielded_cloud.h"

namespace tool_path_stretcher {
namespace {

constexpr double kApart = 0.94;  // cosine: 20 degrees, where hidden areas change little; chosen

struct Cluster {
  Eigen::Vector3d sum;
  std::size_t count = 0;
};

/// A vector that a point carries.
/// @param offsets as returned by offsets_of()
Eigen::Vector3d vector_at(const scan_cell_common::CloudView& cloud, std::size_t point,
                          const std::vector<std::size_t>& offsets) {
  Eigen::Vector3f result;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    std::memcpy(&result[axis],
                cloud.data + point * cloud.step + offsets[static_cast<std::size_t>(axis)],
                sizeof(float));
  return result.cast<double>();
}

}  // namespace

Points directions_seen_from(const Points& points, const Points& viewers) {
  constexpr double kFew = 0.02;  // of the points; chosen
  std::vector<Cluster> clusters;
  std::size_t all = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d way = viewers[i] - points[i];
    if (!way.allFinite() || way.isZero()) continue;
    const Eigen::Vector3d direction = way.normalized();
    auto cluster = std::find_if(clusters.begin(), clusters.end(), [&](const Cluster& each) {
      return each.sum.normalized().dot(direction) > kApart;
    });
    if (cluster == clusters.end())
      cluster = clusters.insert(cluster, {direction, 0});
    else
      cluster->sum += direction;
    ++cluster->count;
    ++all;
  }
  Points result;
  for (const Cluster& cluster : clusters) {
    if (static_cast<double>(cluster.count) >= kFew * static_cast<double>(all))
      result.push_back(cluster.sum.normalized());
  }
  return result;
}

Points directions_seen_from(const scan_cell_common::CloudView& cloud) {
  constexpr std::size_t kLooked = 20000;  // points, evenly through the cloud; chosen
  const std::vector<std::size_t> place = scan_cell_common::offsets_of(cloud.fields, "");
  const std::vector<std::size_t> viewer = scan_cell_common::offsets_of(cloud.fields, "vp_");
  if (place.empty() || viewer.empty()) return {};
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / kLooked);
  Points points, viewers;
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    points.push_back(vector_at(cloud, i, place));
    viewers.push_back(vector_at(cloud, i, viewer));
  }
  return directions_seen_from(points, viewers);
}

}  // namespace tool_path_stretcher
