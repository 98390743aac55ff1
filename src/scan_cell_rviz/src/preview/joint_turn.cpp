// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "preview/joint_turn.h"

#include <urdf/model.h>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "preview/preview_view.h"
#include "scan_cell_common/pose/units.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::WorkPreview;

/// An angle, and its pose.
using AngleAt = std::pair<double, std::size_t>;

QString degrees_of(double angle) {
  return QString::number(angle * scan_cell_common::kDegrees, 'f', 0);
}

/// The robot's range, narrowed by its driver.
std::optional<JointLimits> range_of(const JointTurn& turn, const RobotLimits& limits) {
  const auto found = limits.of_robot.find(turn.joint);
  if (found == limits.of_robot.end()) return std::nullopt;
  JointLimits range = found->second;
  if (turn.place < limits.lower.size())
    range.lower = std::max(range.lower, limits.lower[turn.place]);
  if (turn.place < limits.upper.size())
    range.upper = std::min(range.upper, limits.upper[turn.place]);
  return range;
}

std::size_t place_of(const std::string& joint, const WorkPreview& preview) {
  const auto& names = preview.joint_names;
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), joint) - names.begin());
}

}  // namespace

std::map<std::string, JointLimits> limits_in(const std::string& urdf) {
  std::map<std::string, JointLimits> limits;
  urdf::Model model;
  if (urdf.empty() || !model.initString(urdf)) return limits;
  for (const auto& [name, joint] : model.joints_)
    if (joint->type == urdf::Joint::REVOLUTE && joint->limits)
      limits[name] = {joint->limits->lower, joint->limits->upper};
  return limits;
}

std::optional<JointTurn> most_turned(const WorkPreview& preview) {
  std::map<std::string, std::pair<AngleAt, AngleAt>> ends;  // least and greatest
  for (std::size_t pose = 0; pose < preview.path_waypoints.size(); ++pose) {
    if (preview.path_waypoints[pose] < 0) continue;
    for (const auto& [joint, angle] : joints_at(preview, pose)) {
      const AngleAt here{angle, pose};
      auto& [least, greatest] = ends.try_emplace(joint, here, here).first->second;
      if (angle < least.first) least = here;
      if (angle > greatest.first) greatest = here;
    }
  }
  std::optional<JointTurn> most;
  for (const auto& [joint, of] : ends) {
    const auto& [least, greatest] = of;
    const bool more = !most || greatest.first - least.first > std::abs(most->to - most->from);
    if (least.second == greatest.second || !more) continue;
    const bool upwards = least.second < greatest.second;
    const std::size_t place = place_of(joint, preview);
    most = upwards ? JointTurn{joint, place, least.first, greatest.first}
                   : JointTurn{joint, place, greatest.first, least.first};
  }
  return most;
}

QString text_of(const JointTurn& turn, const RobotLimits& limits) {
  const QString text =
      QCoreApplication::translate("JointTurn",
                                  "%1 turns most along the path: from %2 to %3 degrees")
          .arg(QString::fromStdString(turn.joint), degrees_of(turn.from), degrees_of(turn.to));
  const auto range = range_of(turn, limits);
  if (!range) return text + ".";
  return text + QCoreApplication::translate("JointTurn", "; its range is %1 to %2 degrees.")
                    .arg(degrees_of(range->lower), degrees_of(range->upper));
}

}  // namespace scan_cell_rviz
