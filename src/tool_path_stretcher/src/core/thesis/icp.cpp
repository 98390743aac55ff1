// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/registration/icp.h>

#include "thesis/pcl_clouds.h"
#include "thesis/registrations.h"

namespace tool_path_stretcher {

Similarity register_by_icp(const Points& reference, const Points& object, double scale) {
  constexpr int kIterations = 100;  // at most; chosen
  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
  icp.setInputSource(cloud_of(relative_to(object, Eigen::Vector3d::Zero(), scale)));
  icp.setInputTarget(cloud_of(reference));
  icp.setMaximumIterations(kIterations);
  pcl::PointCloud<pcl::PointXYZ> aligned;
  icp.align(aligned);
  return inverse_of(icp.getFinalTransformation(), scale);
}

}  // namespace tool_path_stretcher
