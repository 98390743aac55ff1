// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/stage.h"

#include <pcl/common/common.h>

#include <cstdio>

#include "scan_cell_common/errors.h"

namespace cloud_preprocess {

using scan_cell_common::UnusableInput;

Cloud Stage::run(Cloud cloud, StageReport& report) const {
  report = {name(), cloud.size(), 0, 0, ""};
  report.non_finite = scan_cell_common::remove_non_finite(cloud);
  if (cloud.empty()) {
    throw UnusableInput(name() + ": cloud",
                        report.points_in == 0
                            ? "no points"
                            : "no finite point among " + std::to_string(report.points_in),
                        "scan again, and check exposure and laser");
  }
  try {
    report.message = apply(cloud);
  } catch (const UnusableInput& error) {
    throw UnusableInput(name() + ": " + error.thing(), error.value(), error.cure());
  }
  if (cloud.empty()) {
    throw UnusableInput(name() + ": cloud", "nothing is left: " + report.message,
                        "set the limits by hand, or leave this stage out");
  }
  if (report.non_finite > 0) {
    report.message += "; " + std::to_string(report.non_finite) + " points were not finite";
  }
  report.points_out = cloud.size();
  return cloud;
}

std::string bounds_text(const Cloud& cloud) {
  pcl::PointXYZ least, most;
  pcl::getMinMax3D(cloud, least, most);
  char text[160];
  std::snprintf(text, sizeof(text), "x %.4f .. %.4f, y %.4f .. %.4f, z %.4f .. %.4f m",
                static_cast<double>(least.x), static_cast<double>(most.x),
                static_cast<double>(least.y), static_cast<double>(most.y),
                static_cast<double>(least.z), static_cast<double>(most.z));
  return text;
}

}  // namespace cloud_preprocess
