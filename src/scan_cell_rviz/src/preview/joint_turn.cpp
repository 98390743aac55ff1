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

/// An angle, and the pose where it is.
using AngleAt = std::pair<double, std::size_t>;

QString degrees_of(double angle) {
  return QString::number(angle * scan_cell_common::kDegrees, 'f', 0);
}

}  // namespace

RobotLimits limits_in(const std::string& urdf) {
  RobotLimits limits;
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
    most = upwards ? JointTurn{joint, least.first, greatest.first}
                   : JointTurn{joint, greatest.first, least.first};
  }
  return most;
}

QString text_of(const JointTurn& turn, const RobotLimits& limits) {
  const QString text =
      QCoreApplication::translate("JointTurn",
                                  "%1 turns most along the path: from %2 to %3 degrees")
          .arg(QString::fromStdString(turn.joint), degrees_of(turn.from), degrees_of(turn.to));
  const auto found = limits.find(turn.joint);
  if (found == limits.end()) return text + ".";
  return text + QCoreApplication::translate("JointTurn", "; it can from %1 to %2.")
                    .arg(degrees_of(found->second.lower), degrees_of(found->second.upper));
}

}  // namespace scan_cell_rviz
