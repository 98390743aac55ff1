// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
/// What the driver lets pass, the emulated controller carries out: two independent plans of a line.
#include <gtest/gtest.h>

#include <random>

#include "robot/motion_check.h"
#include "robot/smart5_six.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/csv_reader.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_sim/controller/controller.h"
#include "scan_cell_sim/controller/path.h"

namespace {

/// [%] at which the controller need not go slower than it was told; 0 where it refuses.
double max_override_of_the_controller(const c4g_driver::RobotState& from,
                                      const Eigen::Isometry3d& target,
                                      const c4g_driver::MotionSettings& settings) {
  scan_cell_sim::LineSettings line;
  line.speed = settings.linear_speed;
  line.rotational_speed = settings.rotational_speed;
  line.euler = settings.euler;
  try {
    const auto plan = scan_cell_sim::plan_line(from.joints, target, line);
    return std::min(100.0, 100 * plan.max_speed / plan.speed);
  } catch (const scan_cell_sim::ControllerRefusal&) {
    return 0;
  }
}

c4g_driver::RobotState standing_at_the_start() {
  c4g_driver::RobotState state;
  state.mode = c4g_driver::ControllerMode::kRemote;
  state.joints = scan_cell_sim::Controller::start_posture();
  state.flange = scan_cell_sim::flange_of(state.joints);
  return state;
}

c4g_driver::RobotLimits limits_in_automatic() {
  c4g_driver::RobotLimits limits;
  limits.operation = c4g_driver::Operation::kAutomatic;
  return narrowed(limits, smart5_six());
}

}  // namespace

TEST(MotionCheck, LetsPassWhatTheControllerCarriesOutAtTheSpeedItWasTold) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> some(-1, 1);
  const c4g_driver::RobotState from = standing_at_the_start();
  const c4g_driver::RobotLimits limits = limits_in_automatic();
  c4g_driver::MotionSettings settings;
  settings.linear_speed = 1;
  settings.rotational_speed = 3;
  settings.override = 1e-3;  // the check tells how much more it would let pass
  int passed = 0, refused = 0;
  for (int i = 0; i < 150; ++i) {
    Eigen::Isometry3d target =
        looking_down(0.8 + 0.7 * some(random), some(random), 0.7 + 0.6 * some(random));
    target.rotate(Eigen::AngleAxisd(1.5 * some(random), Eigen::Vector3d::UnitZ()));
    target.rotate(Eigen::AngleAxisd(0.7 * some(random), Eigen::Vector3d::UnitX()));
    target.rotate(Eigen::AngleAxisd(0.7 * some(random), Eigen::Vector3d::UnitY()));
    const double theirs = max_override_of_the_controller(from, target, settings);
    try {
      const double ours =
          c4g_driver::MotionCheck(smart5_six(), limits, from, settings).to_pose(target);
      ++passed;
      EXPECT_LE(ours, 1.05 * theirs) << "line " << i;  // theirs is a mean over longer steps
    } catch (const scan_cell_common::Refused& error) {
      ++refused;
      // nearer to a singular posture than ours lets it, the controller would crawl
      EXPECT_LT(theirs, 35) << "line " << i << ": " << error.what();
    }
  }
  EXPECT_GT(passed, 40);
  EXPECT_GT(refused, 25);
}

TEST(MotionCheck, LetsPassTheTaughtPosesOfTheSimulatedCalibration) {
  const std::string text = scan_cell_common::read_file(CALIBRATION_POSES);
  scan_cell_common::CsvReader poses(text, CALIBRATION_POSES);
  ASSERT_TRUE(poses.next());  // the columns' names
  c4g_driver::RobotState from = standing_at_the_start();
  const c4g_driver::RobotLimits limits = limits_in_automatic();
  c4g_driver::MotionSettings settings;
  settings.linear_speed = 0.4;
  settings.rotational_speed = M_PI / 3;
  int passed = 0;
  while (poses.next()) {
    const Eigen::Isometry3d target = poses.pose(0);
    EXPECT_NO_THROW(c4g_driver::MotionCheck(smart5_six(), limits, from, settings).to_pose(target))
        << "pose " << passed;
    from.joints = scan_cell_sim::reach(target, from.joints);
    from.flange = target;
    ++passed;
  }
  EXPECT_GT(passed, 20);
}
