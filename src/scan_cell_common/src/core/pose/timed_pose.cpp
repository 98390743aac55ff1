// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/pose/timed_pose.h"

#include <fmt/format.h>

#include <string>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

Eigen::Isometry3d interpolate(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to,
                              double fraction) {
  const Eigen::Quaterniond start(from.linear());
  const Eigen::Quaterniond end(to.linear());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = start.slerp(fraction, end).normalized().toRotationMatrix();
  pose.translation() = from.translation() + fraction * (to.translation() - from.translation());
  return pose;
}

Eigen::Isometry3d interpolate(const TimedPose& before, const TimedPose& after, Nanoseconds time) {
  if (time < before.time || time > after.time) {
    throw Refused(fmt::format("pose at {} ns", time),
                  fmt::format("measured from {} to {} ns", before.time, after.time),
                  "ask for a time between measured poses");
  }
  if (before.time == after.time) return before.pose;
  const double fraction =
      static_cast<double>(time - before.time) / static_cast<double>(after.time - before.time);
  return interpolate(before.pose, after.pose, fraction);
}

}  // namespace scan_cell_common
