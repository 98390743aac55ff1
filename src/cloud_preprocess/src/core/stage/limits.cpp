// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/limits.h"

#include <algorithm>

#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {
namespace {

void check_order(char axis, double least, double most) {
  if (least < most) return;
  const std::string name(1, axis);
  throw scan_cell_common::InvalidParameter(
      name + "_min", std::to_string(least),
      "give less than " + name + "_max, which is " + std::to_string(most));
}

}  // namespace

bool Limits::contain(const pcl::PointXYZ& point) const {
  return point.x >= x_min && point.x <= x_max && point.y >= y_min && point.y <= y_max &&
         point.z >= z_min && point.z <= z_max;
}

void check_order(const Limits& limits) {
  check_order('x', limits.x_min, limits.x_max);
  check_order('y', limits.y_min, limits.y_max);
  check_order('z', limits.z_min, limits.z_max);
}

std::string cut(Cloud& cloud, const Limits& limits) {
  const auto outside = [&limits](const pcl::PointXYZ& point) { return !limits.contain(point); };
  const auto kept = std::remove_if(cloud.begin(), cloud.end(), outside);
  if (kept == cloud.begin()) {
    throw scan_cell_common::UnusableInput("limits", "no point lies within them",
                                          "widen them: the cloud has " + bounds_text(cloud));
  }
  const auto removed = cloud.end() - kept;
  cloud.erase(kept, cloud.end());
  return removed > 0 ? std::to_string(removed) + " outside the limits, " : "";
}

}  // namespace cloud_preprocess
