// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/ros/scan_goal.h"

#include <fmt/format.h>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"

namespace scan_cell {

using scan_cell_common::Refused;

namespace {

scan_cell_msgs::ScanPass to_message(const ScanPass& pass) {
  scan_cell_msgs::ScanPass message;
  message.name = pass.name;
  message.kind = static_cast<std::uint8_t>(pass.kind);
  for (const Eigen::Isometry3d& pose : pass.poses)
    message.poses.push_back(scan_cell_common::to_ros_pose(pose));
  message.speed = pass.speed;
  message.rate = pass.rate;
  message.lasers = static_cast<std::uint8_t>(pass.lasers);
  message.exposure = pass.camera.exposure.value_or(0);
  message.detector = pass.camera.detector;
  message.own_region = static_cast<std::uint8_t>(pass.camera.region.has_value());
  const CameraRegion region = pass.camera.region.value_or(CameraRegion());
  message.region_x = region.x;
  message.region_y = region.y;
  message.region_width = region.width;
  message.region_height = region.height;
  return message;
}

void check_word(const std::string& name, int value, int least, int most, const std::string& cure) {
  if (value < least || value > most) throw Refused(name, fmt::format("{}", value), cure);
}

}  // namespace

scan_cell_msgs::ScanGoal scan_goal(const ScanProgram& program, const std::string& scan_id) {
  scan_cell_msgs::ScanGoal goal;
  goal.scan_id = scan_id;
  goal.frame = program.frame;
  for (const ScanPass& pass : program.passes)
    goal.passes.push_back(to_message(pass));
  return goal;
}

ScanPass pass_from(const scan_cell_msgs::ScanPass& message, const std::string& name) {
  using Message = scan_cell_msgs::ScanPass;
  check_word(name + ": kind", message.kind, Message::LINE, Message::POLYLINE,
             "give LINE, ARC or POLYLINE");
  check_word(name + ": lasers", message.lasers, Message::LASER_0, Message::ALTERNATE,
             "give LASER_0, LASER_1, EACH or ALTERNATE");
  ScanPass pass;
  pass.name = message.name;
  pass.kind = static_cast<PassKind>(message.kind);
  for (std::size_t i = 0; i < message.poses.size(); ++i) {
    pass.poses.push_back(scan_cell_common::checked_from_ros<Refused>(
        message.poses[i], fmt::format("{}: orientation of pose {}", name, i + 1)));
  }
  pass.speed = message.speed;
  pass.rate = message.rate;
  pass.lasers = static_cast<PassLasers>(message.lasers);
  pass.camera.detector = message.detector;
  if (message.exposure != 0) pass.camera.exposure = message.exposure;
  if (message.own_region != 0) {
    pass.camera.region = CameraRegion{message.region_x, message.region_y, message.region_width,
                                      message.region_height};
  }
  return pass;
}

}  // namespace scan_cell
