// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/stage.h"

#include <fmt/format.h>
#include <pcl/common/common.h>
#include <pcl/common/point_tests.h>

#include <utility>

#include "scan_cell_common/errors/errors.h"

namespace cloud_preprocess {

using scan_cell_common::UnusableInput;

Cloud Stage::run(Cloud cloud, StageReport& report) const {
  TracedCloud traced(std::move(cloud));
  run(traced, report);
  return traced.cloud();
}

void Stage::run(TracedCloud& cloud, StageReport& report) const {
  report = {name(), cloud.cloud().size(), 0, 0, ""};
  report.non_finite = cloud.keep_if([&](std::size_t i) { return pcl::isFinite(cloud.cloud()[i]); });
  if (cloud.cloud().empty()) {
    throw UnusableInput(name() + ": cloud",
                        report.points_in == 0
                            ? "no points"
                            : fmt::format("no finite point among {}", report.points_in),
                        "scan again, and check exposure and laser");
  }
  try {
    report.message = apply(cloud);
  } catch (const UnusableInput& error) {
    throw UnusableInput(name() + ": " + error.thing(), error.value(), error.cure());
  }
  if (cloud.cloud().empty()) {
    throw UnusableInput(name() + ": cloud", "nothing is left: " + report.message,
                        "set the limits by hand, or leave this stage out");
  }
  if (report.non_finite > 0) {
    report.message += fmt::format("; {} points were not finite", report.non_finite);
  }
  report.points_out = cloud.cloud().size();
}

std::string bounds_text(const Cloud& cloud) {
  pcl::PointXYZ least, most;
  pcl::getMinMax3D(cloud, least, most);
  return fmt::format("x {:.4f} .. {:.4f}, y {:.4f} .. {:.4f}, z {:.4f} .. {:.4f} m", least.x,
                     most.x, least.y, most.y, least.z, most.z);
}

}  // namespace cloud_preprocess
