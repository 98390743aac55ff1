// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "geometry/points.h"
#include "tool_path_stretcher/similarity.h"

namespace tool_path_stretcher {

pcl::PointCloud<pcl::PointXYZ>::Ptr cloud_of(const Points& points);

/// (p - centre) / divisor
Points relative_to(const Points& points, const Eigen::Vector3d& centre, double divisor);

/// p' = s T^-1 p, where T maps the object, at the reference's size, to the reference.
Similarity inverse_of(const Eigen::Matrix4f& to_reference, double scale);

}  // namespace tool_path_stretcher
