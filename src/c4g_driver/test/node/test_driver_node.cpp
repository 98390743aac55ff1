// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <scan_cell_msgs/GetControllerParameter.h>
#include <scan_cell_msgs/GetStaticPose.h>
#include <scan_cell_msgs/SetControllerParameter.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "node/driver_node_test.h"
#include "scan_cell_common/testing/child_process.h"

using namespace driver_node_test;  // NOLINT

namespace {

const char* const kListen = "--listen";

std::filesystem::path own_program() {
  return std::filesystem::read_symlink("/proc/self/exe");
}

/// A client, as the driver sees it.
int listen() {
  ros::NodeHandle node;
  const Latest<RobotStatus> status(node, "/c4g_driver/status");
  ros::spin();
  return 0;
}

/// Exit code of a shell command, and all its output.
std::pair<int, std::string> run_command(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::string said;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
    said += static_cast<char>(c);
  return {WEXITSTATUS(pclose(pipe)), said};
}

}  // namespace

TEST_F(Driver, ReadsAndWritesParametersAndTheStaticPose) {
  using scan_cell_msgs::GetControllerParameter;
  using scan_cell_msgs::SetControllerParameter;
  SetControllerParameter::Request set;
  set.name = "motion_type";
  set.value = "\"joint\"";
  EXPECT_TRUE(call<SetControllerParameter>("set_parameter", set).success);
  const auto name = with(&GetControllerParameter::Request::name, std::string("motion_type"));
  EXPECT_EQ(call<GetControllerParameter>("get_parameter", name).value, "\"joint\"");
  set.value = "joint";  // not JSON
  EXPECT_FALSE(call<SetControllerParameter>("set_parameter", set).success);
  const auto pose = call<scan_cell_msgs::GetStaticPose>("get_static_pose", {});
  EXPECT_TRUE(pose.success);
  EXPECT_LT(distance(from_ros(pose.pose.pose), truth()), 1e-5);
  EXPECT_EQ(pose.pose.header.frame_id, "base_link");
  EXPECT_EQ(pose.joints.position.size(), 6u);
  start_long_move();  // in joints, a line or not
  EXPECT_FALSE(call<scan_cell_msgs::GetStaticPose>("get_static_pose", {}).success);
}

TEST_F(Driver, EndsTheGoalAtAnEmergencyStop) {
  start_long_move();
  controller_->press_e_stop();
  ASSERT_TRUE(move_.waitForResult(kPatience));
  EXPECT_EQ(move_.getState(), GoalState::ABORTED);
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::STOPPED);
  EXPECT_EQ(move_.getResult()->message, "emergency stop");
  EXPECT_TRUE(eventually([this] {
    return status_.is([](const RobotStatus& status) {
      return status.e_stopped == RobotStatus::YES && status.motion_possible == RobotStatus::NO;
    });
  }));
  EXPECT_EQ(run(to_pose(looking_down(0.8, 0, 0.6))).outcome, MoveResult::REFUSED);
  controller_->release_e_stop();
  EXPECT_EQ(run(to_pose(looking_down(0.8, 0, 0.6))).outcome, MoveResult::REFUSED) << "an alarm";
  EXPECT_FALSE(call<std_srvs::SetBool>("set_drives",
                                       with(&std_srvs::SetBool::Request::data, std::uint8_t{1}))
                   .success);
  EXPECT_TRUE(call<std_srvs::Trigger>("reset_alarms", {}).success);
  EXPECT_TRUE(call<std_srvs::SetBool>("set_drives",
                                      with(&std_srvs::SetBool::Request::data, std::uint8_t{1}))
                  .success);
  EXPECT_EQ(controller_->motions_begun(), 1u);
  EXPECT_EQ(run(to_pose(looking_down(0.8, 0, 0.6))).outcome, MoveResult::REACHED);
}

TEST(OtherDriver, SpeaksWithAControllerProcessOverABadWire) {
  MoveClient move("/other/other_driver/move", true);
  ASSERT_TRUE(move.waitForServer(kPatience));
  ros::NodeHandle node;
  const Latest<RobotStatus> status(node, "/other/other_driver/status");
  ASSERT_TRUE(
      eventually([&] { return status.is([](const RobotStatus& now) { return now.connected; }); }));
  move.sendGoal(to_pose(looking_down(0.80, 0.05, 0.60)));
  ASSERT_TRUE(move.waitForResult(kPatience));
  EXPECT_EQ(move.getResult()->outcome, MoveResult::REACHED) << move.getResult()->message;
  EXPECT_LT(distance(from_ros(move.getResult()->pose.pose), looking_down(0.80, 0.05, 0.60)), 1e-4);
}

TEST_F(Driver, StopsWhereTheWatcherOfTheGoalDies) {
  MoveGoal goal = to_pose(looking_down(0.80, 0.35, 0.60));
  goal.watcher = "/watcher";
  const MoveResult refused = run(goal);
  EXPECT_EQ(refused.outcome, MoveResult::REFUSED);
  EXPECT_NE(refused.message.find("watcher: '/watcher'"), std::string::npos) << refused.message;
  EXPECT_EQ(controller_->motions_begun(), 0u);

  scan_cell_common::ChildProcess watcher({own_program(), kListen, "__name:=watcher"});
  ASSERT_TRUE(eventually([&] {
    ros::WallDuration(0.1).sleep();  // goals without a pause would keep the watcher from starting
    move_.sendGoal(goal);
    return !move_.waitForResult(ros::Duration(0.3)) && controller_->motions_begun() == 1;
  })) << move_.getResult()->message;
  kill(watcher.id(), SIGKILL);
  watcher.wait();
  ASSERT_TRUE(move_.waitForResult(kPatience));
  EXPECT_EQ(move_.getState(), GoalState::ABORTED);
  EXPECT_EQ(move_.getResult()->outcome, MoveResult::STOPPED);
  EXPECT_LT(truth().translation().y(), 0.34);
  EXPECT_EQ(controller_->motions_begun(), 1u);
}

TEST(DriverStart, RefusesBadParametersByName) {
  const std::string address = "_address:=127.0.0.1 ";
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"", "/refused/address: not set"},
      {"_address:=robot", "'robot'"},
      {address + "_port:=0", "/refused/port: 0"},
      {address + "_port:=5410.5", "/refused/port: wrong type"},
      {address + "_port:=35412 _adress:=127.0.0.1", "/refused/adress: no such parameter"},
      {address + "_max_linear_speed:=fast", "/refused/max_linear_speed: wrong type"},
      {address + "_operation:=fast", "/refused/operation: 'fast'"},
      {address + "_flange_link:=hand", "robot description: no chain from 'base_link' to 'hand'"}};
  for (const auto& [parameters, complaint] : bad) {
    const auto [code, said] =
        run_command("rosrun c4g_driver c4g_driver_node __name:=refused " + parameters);
    EXPECT_EQ(code, 1) << parameters;
    EXPECT_NE(said.find(complaint), std::string::npos) << parameters << ": " << said;
    ros::param::del("/refused");
  }
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_c4g_driver");
  if (argc > 1 && argv[1] == std::string(kListen)) return listen();
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
