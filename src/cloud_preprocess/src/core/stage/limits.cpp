// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/limits.h"

#include <fmt/format.h>

#include <algorithm>

#include "cloud_preprocess/stage.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace cloud_preprocess {
namespace {

void describe_axis(scan_cell_common::ParameterTable& table, const std::string& axis, double& min,
                   double& max) {
  const std::string meaning =
      "limit set by hand, in the cloud's frame; applied before anything else";
  table.add(axis + "_min", min, {-Limits::kNone, Limits::kNone, "m"}, meaning);
  table.add(axis + "_max", max, {-Limits::kNone, Limits::kNone, "m"}, meaning);
  if (min < max) return;
  table.refuse(axis + "_min", fmt::format("{:g}", min),
               fmt::format("give less than {}_max, which is {:g}", axis, max));
}

}  // namespace

void describe(scan_cell_common::ParameterTable& table, Limits& limits) {
  describe_axis(table, "x", limits.x_min, limits.x_max);
  describe_axis(table, "y", limits.y_min, limits.y_max);
  describe_axis(table, "z", limits.z_min, limits.z_max);
}

bool Limits::contain(const pcl::PointXYZ& point) const {
  return point.x >= x_min && point.x <= x_max && point.y >= y_min && point.y <= y_max &&
         point.z >= z_min && point.z <= z_max;
}

std::string cut(TracedCloud& cloud, const Limits& limits) {
  const Cloud& points = cloud.cloud();
  const auto within = [&limits](const pcl::PointXYZ& point) { return limits.contain(point); };
  if (std::none_of(points.begin(), points.end(), within)) {
    throw scan_cell_common::UnusableInput("limits", "no point lies within them",
                                          "widen them: the cloud has " + bounds_text(points));
  }
  const std::size_t removed = cloud.keep_if([&](std::size_t i) { return within(points[i]); });
  return removed > 0 ? fmt::format("{} outside the limits, ", removed) : "";
}

}  // namespace cloud_preprocess
