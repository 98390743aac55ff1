// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "thesis/pcl_clouds.h"

#include <memory>

#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

pcl::PointCloud<pcl::PointXYZ>::Ptr cloud_of(const Points& points) {
  return std::make_shared<pcl::PointCloud<pcl::PointXYZ>>(to_cloud(points));
}

Points relative_to(const Points& points, const Eigen::Vector3d& centre, double divisor) {
  Points result;
  result.reserve(points.size());
  for (const Eigen::Vector3d& point : points)
    result.push_back((point - centre) / divisor);
  return result;
}

Similarity inverse_of(const Eigen::Matrix4f& to_reference, double scale) {
  const Eigen::Matrix4d back = to_reference.cast<double>().inverse();
  return {scale, nearest_rotation(back.topLeftCorner<3, 3>()), scale * back.topRightCorner<3, 1>()};
}

}  // namespace tool_path_stretcher
