// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "c4g_driver/tool_motion_check.h"
#include "robot/closed_form.h"
#include "robot/inverse_kinematics.h"
#include "robot/smart5_six.h"

/// A robot with a tool whose paths are checked.
namespace c4g_driver {

using Kind = ToolFault::Kind;

class ToolCheckTest : public testing::Test {
 protected:
  ToolCheckTest() {
    limits_.operation = Operation::kAutomatic;
    motion_.flange_to_tip =
        Eigen::Translation3d(0.02, 0, 0.2) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX());
    stand(degrees(0, 8, -124, 0, 48, 0));
  }

  void stand(const Joints& joints) {
    from_.mode = ControllerMode::kRemote;
    from_.joints = joints;
    from_.flange = flange_by_denavit_hartenberg(joints);
  }

  /// Puts the robot at the start of the path, in the posture near these joints.
  void stand_at_begin(const Joints& near) {
    const auto joints = step_to(
        smart5_six(), motion_.waypoints.front().tip * motion_.flange_to_tip.inverse(), near);
    ASSERT_TRUE(joints);
    stand(*joints);
  }

  void add_flange(const Eigen::Isometry3d& flange, double speed = 0.05) {
    ToolWaypoint waypoint;
    waypoint.tip = flange * motion_.flange_to_tip;
    waypoint.speed = speed;
    motion_.waypoints.push_back(waypoint);
  }

  /// The flange looks down; its path runs along a line.
  void add_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int count,
                double speed = 0.05) {
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d place = from + (to - from) * i / (count - 1);
      add_flange(looking_down(place.x(), place.y(), place.z()), speed);
    }
  }

  ToolCheck check() const {
    return check_tool_motion(smart5_six(), narrowed(limits_, smart5_six()), from_, motion_,
                             parameters_);
  }

  static const ToolFault* first_of(const ToolCheck& check, ToolFault::Kind kind) {
    for (const ToolFault& fault : check.faults) {
      if (fault.kind == kind) return &fault;
    }
    return nullptr;
  }

  RobotLimits limits_;
  RobotState from_;
  ToolMotion motion_;
  ToolCheckParameters parameters_;
};

inline void expect_within(const std::string& said, const std::string& wanted) {
  EXPECT_NE(said.find(wanted), std::string::npos) << "'" << said << "', not '" << wanted << "'";
}

}  // namespace c4g_driver
