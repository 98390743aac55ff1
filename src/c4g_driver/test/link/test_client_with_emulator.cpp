// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The client against the emulated controller: two independent readings of the protocol.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <random>

#include "c4g_driver/client.h"
#include "robot/closed_form.h"
#include "robot/smart5_six.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_sim/controller/controller.h"

using c4g_driver::Client;
using c4g_driver::Goal;
using c4g_driver::MeasuredState;
using scan_cell_sim::Controller;

namespace {

scan_cell_sim::ControllerOptions any_port() {
  scan_cell_sim::ControllerOptions options;
  options.port = 0;
  return options;
}

class Together : public testing::Test {
 protected:
  void SetUp() override { connect(); }

  void connect() {
    c4g_driver::ClientOptions options;
    options.port = controller_.port();
    options.link_timeout = 2;  // patience for a busy machine
    options.tries = 40;
    options.robot = std::make_shared<c4g_driver::RobotModel>(smart5_six());
    options.limits.operation = c4g_driver::Operation::kAutomatic;
    client_ = std::make_unique<Client>(options, [this](const MeasuredState& state) {
      const Eigen::Isometry3d truth = controller_.flange_at(state.time);
      const std::lock_guard<std::mutex> lock(mutex_);
      places_.push_back(state.robot.flange.translation());
      errors_.push_back((state.robot.flange.translation() - truth.translation()).norm());
    });
    ASSERT_TRUE(eventually([this] { return client_->link().up; }));
  }

  static bool eventually(const std::function<bool()>& condition) {
    for (int i = 0; i < 2000 && !condition(); ++i)
      usleep(10'000);
    return condition();
  }

  void start_long_move() {
    client_->move_to_pose(looking_down(0.8, 0.35, 0.6), 100);
    ASSERT_TRUE(eventually([this] { return truth().translation().y() > 0.03; }));
  }

  Eigen::Isometry3d truth() const { return controller_.state().flange; }

  /// Expects the client connected and the robot standing for the time of ten polls.
  void expect_rest() {
    ASSERT_TRUE(eventually([this] {
      const auto state = client_->latest();
      return client_->link().up && state &&
             state->robot.status != c4g_driver::MotionStatus::kMoving &&
             controller_.state().status != scan_cell_sim::MotionStatus::kMoving;
    }));
    const Eigen::Isometry3d resting = truth();
    EXPECT_LT(resting.translation().y(), 0.349);
    const std::size_t before = heard();
    ASSERT_TRUE(eventually([&] { return heard() >= before + 10; }));
    EXPECT_EQ((truth().translation() - resting.translation()).norm(), 0);
    EXPECT_EQ(controller_.motions_begun(), 1u);
  }

  void expect_a_new_goal_moves_it() {
    client_->move_to_pose(looking_down(0.8, 0, 0.6), 100);
    EXPECT_EQ(client_->wait_for_goal(20).outcome(), Goal::Outcome::kReached);
    EXPECT_EQ(controller_.motions_begun(), 2u);
  }

  std::size_t heard() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return errors_.size();
  }

  std::vector<Eigen::Vector3d> places() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return places_;
  }

  void expect_at(const Eigen::Isometry3d& target) {
    const auto measured = client_->latest()->robot;
    const Eigen::Isometry3d truth = controller_.state().flange;
    for (const Eigen::Isometry3d& pose : {measured.flange, truth}) {
      EXPECT_LT((pose.translation() - target.translation()).norm(), 2e-6);
      EXPECT_LT(Eigen::AngleAxisd(pose.linear().transpose() * target.linear()).angle(), 1e-5);
    }
    EXPECT_LT(
        (flange_by_denavit_hartenberg(measured.joints).translation() - target.translation()).norm(),
        1e-5);
  }

  double median_error() {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::sort(errors_.begin(), errors_.end());
    return errors_.empty() ? 1 : errors_[errors_.size() / 2];
  }

  Controller controller_{any_port()};
  std::mutex mutex_;
  std::vector<double> errors_;
  std::vector<Eigen::Vector3d> places_;  // of the flange, as received
  std::unique_ptr<Client> client_;
};

}  // namespace

TEST_F(Together, ReachPosesInWhateverOrientation) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> tilt(-0.4, 0.4);
  std::uniform_real_distribution<double> turn(-1.0, 1.0);
  client_->set_linear_speed(1.0);
  client_->set_parameter("rotational_speed", "90");
  for (int i = 0; i < 6; ++i) {
    Eigen::Isometry3d target = looking_down(0.8, 0.1 * turn(random), 0.6 + 0.1 * turn(random));
    if (i > 0) {  // the first looks straight down, where the Euler angles are degenerate
      target.rotate(Eigen::AngleAxisd(turn(random), Eigen::Vector3d::UnitZ()));
      target.rotate(Eigen::AngleAxisd(tilt(random), Eigen::Vector3d::UnitX()));
      target.rotate(Eigen::AngleAxisd(tilt(random), Eigen::Vector3d::UnitY()));
    }
    client_->move_to_pose(target, 100);
    const Goal goal = client_->wait_for_goal(20);
    ASSERT_EQ(goal.outcome(), Goal::Outcome::kReached) << goal.message();
    expect_at(target);
  }
}

TEST_F(Together, GoRoundAnArcOnItsCircle) {
  const double radius = 0.1;
  const auto place = [&](double angle) -> Eigen::Vector3d {
    return {0.8 + radius * std::sin(angle), radius * (1 - std::cos(angle)), 0.6};
  };
  const auto pose = [&](double angle) {
    Eigen::Isometry3d result = looking_down(0, 0, 0);
    result.translation() = place(angle);
    result.rotate(Eigen::AngleAxisd(angle / 4, Eigen::Vector3d::UnitZ()));
    return result;
  };
  client_->move_along_arc(pose(2), pose(4.5), 100);
  const Goal goal = client_->wait_for_goal(20);
  ASSERT_EQ(goal.outcome(), Goal::Outcome::kReached) << goal.message();
  expect_at(pose(4.5));
  double farthest = 0, least = 0;
  for (const Eigen::Vector3d& heard : places()) {
    const Eigen::Vector3d from_centre = heard - Eigen::Vector3d(0.8, radius, 0.6);
    farthest =
        std::max({farthest, std::abs(from_centre.norm() - radius), std::abs(from_centre.z())});
    least = std::min(least, from_centre.x());
  }
  EXPECT_LT(farthest, 0.05e-3);
  EXPECT_LT(least, -0.09) << "by the long way round";
}

TEST_F(Together, MoveJointsToWhereDenavitAndHartenbergSay) {
  for (const std::vector<double>& joints :
       std::vector<std::vector<double>>{{0.3, -0.2, -1.9, 0.5, 1.2, -2.0},
                                        {-0.5, 0.4, -1.2, -1.0, 0.7, 4.0},
                                        {0, 0, -M_PI / 2, 0, M_PI / 2, 0}}) {
    client_->move_to_joints(joints, 0);
    const Goal goal = client_->wait_for_goal(20);
    ASSERT_EQ(goal.outcome(), Goal::Outcome::kReached) << goal.message();
    expect_at(
        flange_by_denavit_hartenberg(Eigen::Map<const Eigen::Matrix<double, 6, 1>>(joints.data())));
  }
}

TEST_F(Together, CarryOutEveryMotionOnceOverABadWire) {
  scan_cell_sim::ControllerFaults faults;
  for (auto* wire : {&faults.to_client, &faults.from_client})
    wire->lost = wire->repeated = wire->delayed = 0.2;
  controller_.set_faults(faults);
  for (int i = 1; i <= 8; ++i) {
    const Eigen::Isometry3d target = looking_down(0.8, i % 2 == 0 ? 0.0 : 0.05, 0.6);
    if (i % 4 < 2) {
      client_->move_to_pose(target, 100);
    } else {
      client_->move_along_arc(looking_down(0.82, 0.03, 0.6), target, 100);
    }
    const Goal goal = client_->wait_for_goal(20);
    ASSERT_EQ(goal.outcome(), Goal::Outcome::kReached) << goal.message();
    expect_at(target);
    EXPECT_EQ(controller_.motions_begun(), static_cast<std::uint64_t>(i));
  }
  const auto stream = client_->link().stream;
  EXPECT_GT(stream.lost, 0u);
  EXPECT_GT(stream.repeated, 0u);
  EXPECT_GT(stream.reordered, 0u);
}

TEST_F(Together, KeepTheInstantsOfADriftingClock) {
  scan_cell_sim::ControllerFaults faults;
  faults.clock_drift = 100e-6;
  controller_.set_faults(faults);
  client_->move_to_pose(looking_down(0.8, 0.35, 0.6), 100);
  ASSERT_EQ(client_->wait_for_goal(20).outcome(), Goal::Outcome::kReached);
  client_->move_to_pose(looking_down(0.8, -0.35, 0.6), 100);
  ASSERT_EQ(client_->wait_for_goal(20).outcome(), Goal::Outcome::kReached);
  EXPECT_LT(median_error(), 0.25e-3);  // a millisecond at 0.25 m/s; usually 10 um
}

TEST_F(Together, CheckMotionsRightAfterAStopFromWhereTheRobotWillStand) {
  start_long_move();
  client_->stop();
  c4g_driver::PlannedMotion motion;
  motion.motion.flange = looking_down(0.8, 0, 0.6);
  const c4g_driver::PlanCheck check = client_->check({motion}, true, {});
  EXPECT_EQ(check.refusal, "");
  expect_rest();
}

TEST_F(Together, NeverMoveAgainWhenTheEmergencyStopIsReleased) {
  start_long_move();
  controller_.press_e_stop();
  const Goal goal = client_->wait_for_goal(20);
  EXPECT_EQ(goal.outcome(), Goal::Outcome::kStopped);
  EXPECT_EQ(goal.message(), "emergency stop");
  EXPECT_THROW(client_->move_to_pose(looking_down(0.8, 0, 0.6), 100), scan_cell_common::Refused);
  controller_.release_e_stop();
  expect_rest();
  client_->reset_alarms();
  expect_rest();
  client_->set_drives(true);
  expect_rest();
  expect_a_new_goal_moves_it();
}

TEST_F(Together, NeverMoveAgainWhenTheLinkIsBack) {
  start_long_move();
  scan_cell_sim::ControllerFaults cut;
  cut.to_client.link_down = cut.from_client.link_down = true;
  controller_.set_faults(cut);
  EXPECT_EQ(client_->wait_for_goal(20).outcome(), Goal::Outcome::kLinkLost);
  controller_.set_faults({});
  expect_rest();
  expect_a_new_goal_moves_it();
}

TEST_F(Together, NeverMoveAgainWhenTheControllerWasRestarted) {
  start_long_move();
  controller_.restart(0.3);
  EXPECT_EQ(client_->wait_for_goal(20).outcome(), Goal::Outcome::kLinkLost);
  expect_rest();
  EXPECT_EQ(client_->goal().outcome(), Goal::Outcome::kLinkLost);
  expect_a_new_goal_moves_it();
}

TEST_F(Together, NeverMoveAgainForTheNextClient) {
  start_long_move();
  client_.reset();
  connect();
  expect_rest();
  EXPECT_EQ(client_->goal().outcome(), Goal::Outcome::kNone);
  expect_a_new_goal_moves_it();
}
