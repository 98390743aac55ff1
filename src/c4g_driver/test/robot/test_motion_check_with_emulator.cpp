// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
/// What the driver accepts, the emulated controller carries out: two independent plans of a line,
/// an arc, or a tool path.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "c4g_driver/tool_motion_check.h"
#include "robot/motion_check.h"
#include "robot/smart5_six.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/csv_reader.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/pose/timed_pose.h"
#include "scan_cell_sim/controller/controller.h"
#include "scan_cell_sim/controller/path.h"

namespace {

scan_cell_sim::LineSettings their(const c4g_driver::MotionSettings& settings) {
  scan_cell_sim::LineSettings line;
  line.speed = settings.linear_speed;
  line.rotational_speed = settings.rotational_speed;
  line.euler = settings.euler;
  return line;
}

/// Highest override [%] at which the controller need not slow down; 0 if it refuses.
double max_override_of_the_controller(const std::function<scan_cell_sim::PlannedPath()>& plan) {
  try {
    const auto planned = plan();
    return std::min(100.0, 100 * planned.max_speed / planned.speed);
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
  limits.workspace_min = {-3, -3, -1};
  limits.workspace_max = {3, 3, 3};
  return narrowed(limits, smart5_six());
}

/// The check and the controller's plan of many motions.
class TwoPlans : public testing::Test {
 protected:
  TwoPlans() {
    settings_.linear_speed = 1;
    settings_.rotational_speed = 3;
    settings_.override = 1e-3;  // the check says how much more it would allow
  }

  Eigen::Isometry3d some_pose() {
    Eigen::Isometry3d pose = looking_down(0.8 + 0.7 * some(), some(), 0.7 + 0.6 * some());
    pose.rotate(Eigen::AngleAxisd(1.5 * some(), Eigen::Vector3d::UnitZ()));
    pose.rotate(Eigen::AngleAxisd(0.7 * some(), Eigen::Vector3d::UnitX()));
    pose.rotate(Eigen::AngleAxisd(0.7 * some(), Eigen::Vector3d::UnitY()));
    return pose;
  }

  c4g_driver::MotionCheck check() const {
    return {smart5_six(), limits_in_automatic(), from_, settings_};
  }

  /// @param ours, theirs highest override [%]
  void compare(const std::function<double()>& ours,
               const std::function<scan_cell_sim::PlannedPath()>& plan) {
    const double theirs = max_override_of_the_controller(plan);
    try {
      const double most = ours();
      ++passed_;
      EXPECT_LE(most, 1.05 * theirs) << passed_ << ". passed";  // a mean over longer steps
    } catch (const scan_cell_common::Refused& error) {
      ++refused_;
      // nearer to a singular posture than our check allows, the controller would crawl
      EXPECT_LT(theirs, 35) << refused_ << ". refused: " << error.what();
    }
  }

  /// A tool path that begins where the robot stands and turns about with its wrist nearly straight,
  /// where a small turn of the tool needs a large one of J4 and J6.
  c4g_driver::ToolMotion path_near_a_straight_wrist() {
    from_.joints[4] = (some() < 0 ? -1 : 1) * (0.15 + 0.1 * some());
    from_.flange = scan_cell_sim::flange_of(from_.joints);
    c4g_driver::ToolMotion motion;
    motion.flange_to_tip = Eigen::Translation3d(0.02, 0, 0.2) * turned(0.3);
    c4g_driver::ToolWaypoint waypoint;
    waypoint.tip = from_.flange * motion.flange_to_tip;
    waypoint.speed = 1e-3;  // so slow that no axis is too fast
    for (int i = 0; i < 6; ++i) {
      motion.waypoints.push_back(waypoint);
      waypoint.tip = waypoint.tip * Eigen::Translation3d(0.02 * some(), 0.02 * some(), 0) *
                     turned(0.05 * some());
      waypoint.zone = 1e-3 * (1 + some());
    }
    return motion;
  }

  /// @throw ControllerRefusal
  scan_cell_sim::PlannedPath their_plan(const c4g_driver::ToolMotion& motion) const {
    std::vector<scan_cell_sim::TipWaypoint> waypoints;
    for (const c4g_driver::ToolWaypoint& each : motion.waypoints)
      waypoints.push_back({each.tip, each.speed, each.zone, 0});
    return scan_cell_sim::plan_tool_path(from_.joints, motion.flange_to_tip, waypoints, 0,
                                         their(settings_));
  }

  c4g_driver::RobotState from_ = standing_at_the_start();
  c4g_driver::MotionSettings settings_;
  int passed_ = 0;
  int refused_ = 0;

 private:
  double some() { return std::uniform_real_distribution<double>(-1, 1)(random_); }

  /// [rad] about any axis across the tool's
  Eigen::AngleAxisd turned(double angle) {
    const double across = M_PI * some();
    return {angle, Eigen::Vector3d(std::cos(across), std::sin(across), 0)};
  }

  std::mt19937 random_{17};
};

}  // namespace

TEST_F(TwoPlans, OfALineAgreeSoThatWhatPassesIsCarriedOutAtTheSpeedAskedFor) {
  for (int i = 0; i < 150; ++i) {
    const Eigen::Isometry3d target = some_pose();
    compare([&] { return check().to_pose(target).max_override; },
            [&] { return scan_cell_sim::plan_line(from_.joints, target, their(settings_)); });
  }
  EXPECT_GT(passed_, 40);
  EXPECT_GT(refused_, 25);
}

TEST_F(TwoPlans, OfAnArcAgreeSoThatWhatPassesIsCarriedOutAtTheSpeedAskedFor) {
  for (int i = 0; i < 150; ++i) {
    const Eigen::Isometry3d via = scan_cell_common::interpolate(from_.flange, some_pose(), 0.4);
    const Eigen::Isometry3d target = scan_cell_common::interpolate(from_.flange, some_pose(), 0.6);
    compare([&] { return check().along_arc(via, target).max_override; },
            [&] { return scan_cell_sim::plan_arc(from_.joints, via, target, their(settings_)); });
  }
  EXPECT_GT(passed_, 40);
  EXPECT_GT(refused_, 25);
}

TEST_F(TwoPlans, OfAPathOfTheToolAgreeSoThatWhatPassesIsFollowedToItsEnd) {
  for (int i = 0; i < 400; ++i) {
    const c4g_driver::ToolMotion motion = path_near_a_straight_wrist();
    const auto checked =
        c4g_driver::check_tool_motion(smart5_six(), limits_in_automatic(), from_, motion);
    ++(checked.possible() ? passed_ : refused_);
    if (!checked.possible()) continue;
    EXPECT_NO_THROW(their_plan(motion)) << passed_ << ". passed";
  }
  EXPECT_GT(passed_, 100);
  EXPECT_GT(refused_, 100);
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
