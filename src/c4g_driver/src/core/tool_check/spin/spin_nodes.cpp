// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_check/spin/spin_nodes.h"

#include <cmath>

#include "tool_check/judge/tool_line.h"

namespace c4g_driver {
namespace {

/// `to`, with the least turn from `from` that gives its z.
Eigen::Isometry3d carried(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  Eigen::Isometry3d carried = to;
  const Eigen::Vector3d z = to.linear().col(2);
  carried.linear() = Eigen::Quaterniond::FromTwoVectors(from.linear().col(2), z) * from.linear();
  return carried;
}

double angle_between(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  return Eigen::AngleAxisd(from.linear().transpose() * to.linear()).angle();
}

}  // namespace

SpinPath spin_path(const ToolCheckSubject& subject, double begin) {
  const std::vector<ToolWaypoint>& waypoints = subject.motion.waypoints;
  SpinPath path;
  path.tips.push_back(spun(waypoints.front().tip, begin));
  path.seconds.push_back(0);
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const Eigen::Isometry3d before = path.tips.back();
    path.tips.push_back(carried(before, waypoints[i].tip));
    const double length = (path.tips.back().translation() - before.translation()).norm();
    path.seconds.push_back(path.seconds.back() + std::max(length / waypoints[i].speed,
                                                          angle_between(before, path.tips.back()) /
                                                              subject.parameters.rotational_speed));
  }
  return path;
}

std::vector<SpinNode> spin_nodes(const SpinPath& path, double length, double angle) {
  std::vector<SpinNode> nodes = {{0, path.tips.front(), 0}};
  double gone = 0, turned = 0;
  for (std::size_t i = 1; i < path.tips.size(); ++i) {
    gone += (path.tips[i].translation() - path.tips[i - 1].translation()).norm();
    turned += angle_between(path.tips[i - 1], path.tips[i]);
    if (gone < length && turned < angle && i + 1 < path.tips.size()) continue;
    const double before = path.seconds[nodes.back().waypoint];
    nodes.push_back({i, path.tips[i], path.seconds[i] - before});
    gone = turned = 0;
  }
  return nodes;
}

Eigen::Isometry3d spun(const Eigen::Isometry3d& tip, double turn) {
  return tip * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ());
}

}  // namespace c4g_driver
