// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/flange_way.h"

#include "robot/path_check.h"
#include "robot/paths/arc.h"
#include "robot/paths/line.h"

namespace c4g_driver {
namespace {

std::vector<Eigen::Isometry3d> poses_of(const Path& path) {
  std::vector<Eigen::Isometry3d> poses = {path.at(0)};
  for (const Path::Stretch& stretch : path.stretches()) {
    const double steps = steps_along(stretch);
    for (double step = 1; step <= steps; ++step)
      poses.push_back(path.at(stretch.begin + (stretch.end - stretch.begin) * step / steps));
  }
  return poses;
}

}  // namespace

std::vector<Eigen::Isometry3d> flange_way(const Eigen::Isometry3d& from,
                                          const std::optional<Eigen::Isometry3d>& via,
                                          const Eigen::Isometry3d& to) {
  if (via) return poses_of(Arc(from, *via, to));
  return poses_of(Line(from, to, false));
}

}  // namespace c4g_driver
