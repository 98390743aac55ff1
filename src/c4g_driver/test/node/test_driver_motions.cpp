// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <scan_cell_msgs/CheckMotions.h>
#include <scan_cell_msgs/SetLinearSpeed.h>
#include <scan_cell_msgs/SetOverride.h>

#include <cmath>
#include <limits>

#include "node/driver_node_test.h"

using namespace driver_node_test;  // NOLINT
using scan_cell_common::Nanoseconds;

TEST_F(Driver, MovesAlongALineAndShowsWhereItIs) {
  const Eigen::Isometry3d target = looking_down(0.85, 0.15, 0.55);
  double progress = 0;
  bool forward = true;
  move_.sendGoal(to_pose(target), {}, {},
                 [&](const scan_cell_msgs::MoveFeedbackConstPtr& feedback) {
                   forward = forward && feedback->progress >= progress;
                   progress = feedback->progress;
                 });
  ASSERT_TRUE(move_.waitForResult(kPatience));
  EXPECT_EQ(move_.getState(), GoalState::SUCCEEDED);
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::REACHED);
  EXPECT_LT(distance(from_ros(move_.getResult()->pose.pose), target), 1e-5);
  EXPECT_LT(distance(truth(), target), 1e-5);
  EXPECT_TRUE(forward);
  EXPECT_GT(progress, 0.2);
  EXPECT_LE(progress, 1.0);
  EXPECT_EQ(controller_->state().camera_rate, 100);
}

TEST_F(Driver, MovesAlongAnArcAndShowsThatItIsOnItsCircle) {
  const double radius = 0.1;
  const Eigen::Vector3d centre(0.80, radius, 0.60);
  const auto on_circle = [&](double angle) {
    Eigen::Isometry3d pose = looking_down(0.8, 0, 0.6);
    pose.translation() = centre + radius * Eigen::Vector3d(std::sin(angle), -std::cos(angle), 0);
    pose.rotate(Eigen::AngleAxisd(angle / 3, Eigen::Vector3d::UnitZ()));
    return pose;
  };
  const MoveResult result = run(along_arc(on_circle(1.5), on_circle(4)));
  EXPECT_EQ(result.outcome, MoveResult::REACHED) << result.message;
  EXPECT_LT(distance(truth(), on_circle(4)), 1e-5);
  const auto shown = flange_transforms();
  EXPECT_GT(shown.size(), 100u);
  double farthest = 0, most_turned = 0;
  for (const auto& message : shown) {
    const Eigen::Isometry3d flange = from_ros(message.transform);
    const Eigen::Vector3d offset = flange.translation() - centre;
    const double angle = std::atan2(offset.x(), -offset.y());
    const Eigen::Isometry3d expected = on_circle(angle < -0.1 ? angle + 2 * M_PI : angle);
    farthest = std::max(farthest, distance(flange, expected));
    most_turned = std::max(
        most_turned, Eigen::AngleAxisd(flange.linear().transpose() * expected.linear()).angle());
  }
  EXPECT_LT(farthest, 0.05e-3);
  EXPECT_LT(most_turned, 0.01 * M_PI / 180);
  EXPECT_EQ(controller_->state().camera_rate, 100);
  RecordProperty("farthest_nm", std::to_string(1e9 * farthest));
}

TEST_F(Driver, StopsOnAnArcAndDoesNotGoOn) {
  move_.sendGoal(along_arc(looking_down(0.95, 0.15, 0.60), looking_down(0.80, 0.30, 0.60)));
  ASSERT_TRUE(eventually([this] { return controller_->state().progress > 0.2; }));
  move_.cancelGoal();
  ASSERT_TRUE(move_.waitForResult(kPatience));
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::STOPPED);
  const Eigen::Isometry3d stopped = truth();
  EXPECT_NEAR((stopped.translation() - Eigen::Vector3d(0.80, 0.15, 0.60)).norm(), 0.15, 0.05e-3);
  EXPECT_LT(stopped.translation().y(), 0.29);
  const std::size_t before = flange_transforms().size();
  ASSERT_TRUE(eventually([&] { return flange_transforms().size() > before + 10; }));
  EXPECT_EQ(distance(truth(), stopped), 0);
  EXPECT_EQ(controller_->motions_begun(), 1u);
}

TEST_F(Driver, RunsAtTheSpeedAndOverrideItWasGiven) {
  using scan_cell_msgs::SetLinearSpeed;
  using scan_cell_msgs::SetOverride;
  EXPECT_TRUE(
      call<SetLinearSpeed>("set_linear_speed", with(&SetLinearSpeed::Request::speed, 0.1)).success);
  EXPECT_TRUE(
      call<SetOverride>("set_override", with(&SetOverride::Request::override, 50.0)).success);
  move_.sendGoal(to_pose(looking_down(0.80, 0.10, 0.60)));
  ASSERT_TRUE(eventually([this] { return truth().translation().y() > 0.03; }));
  const Nanoseconds now = from_ros(ros::Time::now());
  const double way =
      distance(controller_->flange_at(now), controller_->flange_at(now - 200'000'000));
  EXPECT_NEAR(way, 0.2 * 0.05, 1e-6);
  EXPECT_TRUE(eventually([this] {
    return status_.is([](const RobotStatus& status) {
      return status.override == 50 && status.linear_speed == 0.1 && status.in_motion == 1;
    });
  }));
}

TEST_F(Driver, ChecksMotionsOneAfterTheOtherAndMovesNothing) {
  using scan_cell_msgs::CheckMotions;
  CheckMotions::Request request;
  request.motions = {to_pose(looking_down(0.80, 0.20, 0.60)),
                     along_arc(looking_down(0.85, 0.15, 0.60), looking_down(0.80, 0.10, 0.60)),
                     to_pose(looking_down(0.80, 0.00, 0.60))};
  request.speeds = {0.2, 0.1, 0.5};
  CheckMotions::Response answer = call<CheckMotions>("check_motions", request);
  EXPECT_TRUE(answer.success);
  EXPECT_EQ(answer.message, "");
  EXPECT_EQ(answer.possible, 3u);
  EXPECT_TRUE(std::isnan(answer.way));
  ASSERT_EQ(answer.joints.size(), 6u);
  EXPECT_NEAR(answer.joints[0], 0, 1e-6) << "straight in front J1 is 0";

  request.motions[2] = to_pose(looking_down(1.35, 0, 1.5));
  answer = call<CheckMotions>("check_motions", request);
  EXPECT_TRUE(answer.success);
  EXPECT_EQ(answer.possible, 2u);
  EXPECT_NE(answer.message.find("target: out of reach by 0."), std::string::npos) << answer.message;
  EXPECT_EQ(answer.way, 1);
  EXPECT_LT(distance(from_ros(answer.pose.pose), looking_down(1.35, 0, 1.5)), 1e-9);
  EXPECT_EQ(answer.pose.header.frame_id, "base_link");

  request.joints = {1, 0, -M_PI / 2, 0, 1, 0};  // from there the first line is different
  request.motions = {to_joints({1.2, 0, -M_PI / 2, 0, 1, 0})};
  request.speeds.clear();
  EXPECT_EQ(call<CheckMotions>("check_motions", request).possible, 1u);
  EXPECT_EQ(controller_->motions_begun(), 0u);
}

TEST_F(Driver, SaysWhyMotionsCouldNotBeChecked) {
  using scan_cell_msgs::CheckMotions;
  CheckMotions::Request request;
  request.motions = {to_pose(looking_down(0.80, 0.20, 0.60))};
  request.speeds = {0.2, 0.2};
  CheckMotions::Response answer = call<CheckMotions>("check_motions", request);
  EXPECT_FALSE(answer.success);
  EXPECT_EQ(answer.message, "speeds: 2 of 1 motions; give one for each motion, or none");
  request.speeds.clear();
  request.motions[0].kind = 7;
  EXPECT_NE(call<CheckMotions>("check_motions", request).message.find("kind of motion"),
            std::string::npos);
  request.motions[0] = to_pose(looking_down(0.80, 0.20, 0.60));
  start_long_move();
  answer = call<CheckMotions>("check_motions", request);
  EXPECT_FALSE(answer.success);
  EXPECT_NE(answer.message.find("the robot is moving"), std::string::npos) << answer.message;
}

TEST_F(Driver, RefusesBadTargetsWithTheReasonAndMovesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MoveGoal other_frame = to_pose(looking_down(0.8, 0, 0.6));
  other_frame.pose.header.frame_id = "world";
  MoveGoal no_rotation = to_pose(looking_down(0.8, 0, 0.6));
  no_rotation.pose.pose.orientation.x = 0;
  MoveGoal no_kind = to_pose(looking_down(0.8, 0, 0.6));
  no_kind.kind = 7;
  const Eigen::Isometry3d via = looking_down(0.85, 0.05, 0.6), end = looking_down(0.8, 0.1, 0.6);
  MoveGoal via_elsewhere = along_arc(via, end);
  via_elsewhere.via.header.frame_id = "world";
  MoveGoal no_via = to_pose(end);
  no_via.kind = MoveGoal::CIRCULAR;
  MoveGoal no_via_rotation = along_arc(via, end);
  no_via_rotation.via.pose.orientation.x = 0;
  const std::vector<std::pair<MoveGoal, std::string>> bad = {
      {via_elsewhere, "via frame: 'world'"},
      {no_via, "via frame: ''"},
      {no_via_rotation, "via orientation"},
      {along_arc(looking_down(0.85, nan, 0.6), end), "via y: nan"},
      {along_arc(end, end), "via: 0 m from the target"},
      {along_arc(looking_down(0.8, 0.05, 0.6), end), "via: only "},
      {along_arc(via, looking_down(0.8, 9, 0.6)), "target y"},
      {to_pose(looking_down(nan, 0, 0.6)), "target x"},
      {to_pose(looking_down(0.8, 9, 0.6)), "target y"},
      {to_pose(looking_down(0.8, 0, 0.05)), "target z"},
      {other_frame, "frame"},
      {no_rotation, "orientation"},
      {no_kind, "kind"},
      {to_joints({0, 0, -1}), "joints"},
      {to_joints({0, 0, 1, 0, 0, 0}), "target J3"},
      {to_joints({0, 0, nan, 0, 0, 0}), "target J3"},
      {to_joints({0, 1.3, -M_PI / 2, 0, 0, 0}), "target z"},  // through the floor
      {to_pose(looking_down(1.35, 0, 1.5)), "reach"}};        // this one the controller refuses
  for (const auto& [goal, reason] : bad) {
    const MoveResult result = run(goal);
    EXPECT_EQ(move_.getState(), GoalState::ABORTED);
    EXPECT_EQ(result.outcome, MoveResult::REFUSED) << reason;
    EXPECT_NE(result.message.find(reason), std::string::npos) << result.message;
  }
  EXPECT_EQ(controller_->motions_begun(), 0u);
  using scan_cell_msgs::SetLinearSpeed;
  using scan_cell_msgs::SetOverride;
  const auto speed =
      call<SetLinearSpeed>("set_linear_speed", with(&SetLinearSpeed::Request::speed, 5.0));
  EXPECT_FALSE(speed.success);
  EXPECT_FALSE(speed.link_lost);
  EXPECT_NE(speed.message.find("linear speed"), std::string::npos);
  EXPECT_FALSE(
      call<SetOverride>("set_override", with(&SetOverride::Request::override, 120.0)).success);
}

TEST_F(Driver, StopsWhenTheGoalIsCancelled) {
  start_long_move();
  move_.cancelGoal();
  ASSERT_TRUE(move_.waitForResult(kPatience));
  EXPECT_EQ(move_.getState(), GoalState::PREEMPTED);
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::STOPPED);
  EXPECT_EQ(controller_->state().status, scan_cell_sim::MotionStatus::kStopped);
  EXPECT_LT(truth().translation().y(), 0.34);
  EXPECT_LT(distance(from_ros(move_.getResult()->pose.pose), truth()), 1e-5);
}

TEST_F(Driver, StopsTheMotionUnderWayForANewGoal) {
  start_long_move();
  MoveClient second("/c4g_driver/move", true);
  ASSERT_TRUE(second.waitForServer(kPatience));
  const Eigen::Isometry3d target = looking_down(0.80, 0, 0.65);
  second.sendGoal(to_pose(target));
  ASSERT_TRUE(second.waitForResult(kPatience));
  EXPECT_EQ(second.getResult()->outcome, MoveResult::REACHED);
  EXPECT_LT(distance(truth(), target), 1e-5);
  EXPECT_TRUE(move_.waitForResult(kPatience));
  EXPECT_EQ(move_.getState(), GoalState::PREEMPTED);
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::STOPPED);
  EXPECT_EQ(controller_->motions_begun(), 2u);
}

TEST_F(Driver, EndsTheGoalOfALostLinkAndDoesNotResumeIt) {
  start_long_move();
  scan_cell_sim::ControllerFaults cut;
  cut.to_client.link_down = cut.from_client.link_down = true;
  controller_->set_faults(cut);
  const ros::WallTime lost = ros::WallTime::now();
  ASSERT_TRUE(move_.waitForResult(kPatience));
  EXPECT_LT((ros::WallTime::now() - lost).toSec(), 1.0);
  EXPECT_EQ(move_.getState(), GoalState::ABORTED);
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::LINK_LOST);
  ASSERT_TRUE(connected(false));
  using scan_cell_msgs::SetLinearSpeed;
  const auto speed =
      call<SetLinearSpeed>("set_linear_speed", with(&SetLinearSpeed::Request::speed, 0.1));
  EXPECT_FALSE(speed.success);
  EXPECT_TRUE(speed.link_lost) << "not a refusal: " << speed.message;
  controller_->set_faults({});
  ASSERT_TRUE(connected(true));
  ASSERT_TRUE(eventually(
      [this] { return controller_->state().status != scan_cell_sim::MotionStatus::kMoving; }));
  const Eigen::Isometry3d stopped = truth();
  EXPECT_LT(stopped.translation().y(), 0.349);
  const std::size_t before = flange_transforms().size();
  ASSERT_TRUE(eventually([&] { return flange_transforms().size() > before + 10; }));
  EXPECT_EQ(distance(truth(), stopped), 0);
  EXPECT_EQ(controller_->motions_begun(), 1u);
  EXPECT_EQ(run(to_pose(looking_down(0.8, 0, 0.6))).outcome, MoveResult::REACHED);
}

TEST_F(Driver, ReportsAnErrorOfTheController) {
  start_long_move();
  controller_->fail_motion("following error of J2");
  ASSERT_TRUE(move_.waitForResult(kPatience));
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::CONTROLLER_ERROR);
  EXPECT_EQ(move_.getResult()->message, "following error of J2");
}
