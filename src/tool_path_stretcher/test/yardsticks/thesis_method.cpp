// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "yardsticks/thesis_method.h"

#include <pcl/common/pca.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/registration/icp.h>

namespace cases {
namespace {

using tool_path_stretcher::Segment;
using tool_path_stretcher::Waypoint;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr cloud_of(const Points& points, double scale) {
  auto cloud = std::make_shared<Cloud>();
  for (const Eigen::Vector3d& point : points) {
    cloud->push_back({static_cast<float>(scale * point.x()), static_cast<float>(scale * point.y()),
                      static_cast<float>(scale * point.z())});
  }
  return cloud;
}

}  // namespace

ToolPath thesis_method(const Points& reference, const Points& object, const ToolPath& path) {
  const auto largest_deviation = [](const Cloud::Ptr& cloud) {
    pcl::PCA<pcl::PointXYZ> pca;
    pca.setInputCloud(cloud);
    return std::sqrt(pca.getEigenValues()[0]);
  };
  const Cloud::Ptr target = cloud_of(reference, 1);
  const double scale = largest_deviation(cloud_of(object, 1)) / largest_deviation(target);
  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
  icp.setInputSource(cloud_of(object, 1 / scale));
  icp.setInputTarget(target);
  icp.setMaximumIterations(100);
  const auto aligned = std::make_shared<Cloud>();
  icp.align(*aligned);
  const Eigen::Matrix4d back = icp.getFinalTransformation().cast<double>().inverse();
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(aligned);
  ToolPath result = path;
  for (Segment& segment : result.segments) {
    for (Waypoint& waypoint : segment.waypoints) {
      const Eigen::Vector3d at = waypoint.pose.translation();
      const pcl::PointXYZ query(static_cast<float>(at.x()), static_cast<float>(at.y()),
                                static_cast<float>(at.z()));
      std::vector<int> index(1);
      std::vector<float> squared(1);
      tree.nearestKSearch(query, 1, index, squared);
      const pcl::PointXYZ& found = (*aligned)[static_cast<std::size_t>(index[0])];
      const Eigen::Vector4d nearest(found.x, found.y, found.z, 1);
      waypoint.pose.translation() = scale * (back * nearest).head<3>();
    }
  }
  return result;
}

}  // namespace cases
