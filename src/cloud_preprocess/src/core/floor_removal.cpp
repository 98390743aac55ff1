// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/floor_removal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "floor_plane.h"

namespace cloud_preprocess {

FloorRemoval::FloorRemoval(const FloorParameters& parameters) : parameters_(parameters) {
  check(parameters_);
}

std::string FloorRemoval::apply(Cloud& cloud) const {
  const std::string message = cut(cloud, parameters_.limits);
  if (!parameters_.automatic) return message + "not looked for a floor";

  const std::optional<Plane> floor = find_floor(cloud, parameters_);
  if (!floor) return message + "no floor found";
  const std::size_t before = cloud.size();
  const auto on_floor = [&](const pcl::PointXYZ& point) {
    return floor->height(point) <= parameters_.margin;
  };
  cloud.erase(std::remove_if(cloud.begin(), cloud.end(), on_floor), cloud.end());
  char text[120];
  std::snprintf(text, sizeof(text), "%zu on or below the floor at z %.4f m, which leans %.2f deg",
                before - cloud.size(), floor->point.z(),
                std::acos(std::min(floor->normal.z(), 1.0)) * 180 / M_PI);
  return message + text;
}

}  // namespace cloud_preprocess
