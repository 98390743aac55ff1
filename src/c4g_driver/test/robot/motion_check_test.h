// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "robot/closed_form.h"
#include "robot/inverse_kinematics.h"
#include "robot/motion_check.h"
#include "robot/smart5_six.h"
#include "scan_cell_common/errors/errors.h"

/// The flange at this angle [deg] of J1 or J5.
inline Eigen::Isometry3d at_j1(double angle) {
  return flange_by_denavit_hartenberg(degrees(angle, 0, -90, 0, 70, 0));
}

inline Eigen::Isometry3d at_j5(double angle) {
  return flange_by_denavit_hartenberg(degrees(0, 0, -90, 0, angle, 0));
}

/// A robot at rest whose motions are checked.
namespace c4g_driver {

class MotionCheckTest : public testing::Test {
 protected:
  MotionCheckTest() {
    limits_.operation = Operation::kAutomatic;
    stand(*step_to(smart5_six(), looking_down(0.8, 0, 0.6), degrees(0, 8, -124, 0, 48, 0)));
  }

  void stand(const Joints& joints) {
    from_.mode = ControllerMode::kRemote;
    from_.joints = joints;
    from_.flange = flange_by_denavit_hartenberg(joints);
  }

  MotionCheck check() const {
    return {smart5_six(), narrowed(limits_, smart5_six()), from_, settings_};
  }

  /// The refusal's text.
  std::string refusal_of_pose(const Eigen::Isometry3d& target) const {
    return refusal([&] { check().to_pose(target); });
  }
  std::string refusal_of_arc(const Eigen::Isometry3d& via, const Eigen::Isometry3d& target) const {
    return refusal([&] { check().along_arc(via, target); });
  }
  std::string refusal_of_joints(const Joints& target) const {
    return refusal([&] { check().to_joints(target); });
  }

  static std::string refusal(const std::function<void()>& ask) {
    try {
      ask();
    } catch (const scan_cell_common::Refused& refused) {
      return refused.what();
    }
    return "";
  }

  RobotLimits limits_;
  RobotState from_;
  MotionSettings settings_;
};

inline void expect_says(const std::string& said, const std::string& wanted) {
  EXPECT_NE(said.find(wanted), std::string::npos) << "'" << said << "', not '" << wanted << "'";
}

}  // namespace c4g_driver
