// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "preview/preview_view.h"

#include <QDir>
#include <QFileInfo>
#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <limits>

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::WorkPreview;

constexpr double kDegree = M_PI / 180;

QString outputs_of(std::uint32_t outputs) {
  QStringList numbers;
  for (int i = 0; i < 32; ++i)
    if ((outputs >> i & 1U) != 0) numbers << QString::number(i + 1);
  return numbers.isEmpty() ? QObject::tr("all outputs off")
                           : QObject::tr("output %1 on").arg(numbers.join(", "));
}

}  // namespace

bool is_of_run(const WorkPreview& preview, const QString& run) {
  return QFileInfo(QString::fromStdString(preview.path)).dir().dirName() == run;
}

std::map<std::string, double> joints_at(const WorkPreview& preview, std::size_t pose) {
  const std::size_t count = preview.joint_names.size();
  std::map<std::string, double> joints;
  if ((pose + 1) * count > preview.joints.size()) return joints;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = preview.joints[pose * count + i];
    if (!std::isfinite(angle)) return {};
    joints[preview.joint_names[i]] = angle;
  }
  return joints;
}

QString text_at(const WorkPreview& preview, std::size_t pose) {
  if (pose >= preview.waypoints.size()) return {};
  const std::int32_t waypoint =
      pose < preview.path_waypoints.size() ? preview.path_waypoints[pose] : -1;
  const auto& at = preview.waypoints[pose];
  QString text = QObject::tr("%1: %2 mm/s, %3")
                     .arg(waypoint < 0 ? QObject::tr("on the way to or from the path")
                                       : QObject::tr("waypoint %1").arg(waypoint))
                     .arg(at.speed * 1e3, 0, 'g', 4)
                     .arg(outputs_of(at.outputs));
  const auto joints = joints_at(preview, pose);
  if (joints.empty()) return text + QObject::tr("\nThe robot does not get there.");
  QStringList angles;
  for (const std::string& name : preview.joint_names)
    angles << QObject::tr("%1 %2")
                  .arg(QString::fromStdString(name))
                  .arg(joints.at(name) / kDegree, 0, 'f', 1);
  return text + "\n" + angles.join(", ") + QObject::tr(" degrees");
}

bool is_along_path(const WorkPreview& preview, std::size_t pose) {
  const auto& waypoints = preview.path_waypoints;
  return pose > 0 && pose < waypoints.size() && waypoints[pose] >= 0 && waypoints[pose - 1] >= 0;
}

SpeedRange speeds_of(const WorkPreview& preview) {
  SpeedRange range{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 1; i < preview.waypoints.size(); ++i) {
    if (!is_along_path(preview, i)) continue;
    range.least = std::min(range.least, preview.waypoints[i].speed);
    range.most = std::max(range.most, preview.waypoints[i].speed);
  }
  if (!(range.least <= range.most)) range.least = range.most;
  return range;
}

scan_cell_common::Rgb colour_of(double speed, const SpeedRange& range) {
  const double width = range.most - range.least;
  return scan_cell_common::brightening(width > 0 ? (speed - range.least) / width : 1);
}

}  // namespace scan_cell_rviz
