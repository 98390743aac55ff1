// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib/server/action_server.h>
#include <scan_cell_msgs/FinishBinding.h>
#include <scan_cell_msgs/RecordPose.h>
#include <scan_cell_msgs/StartRun.h>
#include <scan_cell_msgs/StartScan.h>

#include <boost/asio.hpp>
#include <csignal>
#include <filesystem>

#include "node/scan_client.h"
#include "scan_calibration/taught_poses.h"
#include "scan_cell/ros/cell_client.h"
#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/testing/child_process.h"

namespace fs = std::filesystem;

using namespace scan_test;  // NOLINT
using scan_cell_common::ChildProcess;

TEST_F(ScanClient, FinishesAndGivesAuditAndCloud) {
  const ScanResult result = run(goal("whole"));
  EXPECT_EQ(client_.getState().state_, State::SUCCEEDED) << result.message;
  EXPECT_EQ(result.outcome, ScanResult::FINISHED);
  EXPECT_EQ(result.scan_id, "whole");
  EXPECT_GT(result.audit.triggers, 10U);
  EXPECT_EQ(result.statistics.points, result.audit.triggers);
  EXPECT_FALSE(result.cloud.data.empty());
  EXPECT_EQ(result.message, "0 events missing") << "what the binder says must not be lost";
}

TEST_F(ScanClient, FinishesAndNamesTheFileOfACloudThatIsTooLargeForAMessage) {
  node_.setParam("/fake/cloud", "large");
  const ScanResult result = run(goal("large"));
  EXPECT_EQ(result.outcome, ScanResult::FINISHED) << result.message;
  EXPECT_EQ(result.cloud_file, "/scans/large.ply");
  EXPECT_TRUE(result.cloud.data.empty());
  node_.deleteParam("/fake/cloud");
  EXPECT_EQ(run(goal("small")).cloud_file, "") << "that of the last scan is forgotten";
}

TEST_F(ScanClient, FailsAndKeepsTheDataWhereTriggerEventsAreMissing) {
  node_.setParam("/fake/binder", "missing");
  const ScanResult result = run(goal("events missing"));
  EXPECT_EQ(result.outcome, ScanResult::STAGE_FAILED);
  EXPECT_NE(result.message.find("3 events missing"), std::string::npos) << result.message;
  EXPECT_EQ(result.audit.triggers_missing, 3U);
  EXPECT_EQ(result.statistics.points, result.audit.triggers - 3);
  EXPECT_FALSE(result.cloud.data.empty());
}

TEST_F(ScanClient, RejectsASecondScanByTheNameOfTheFirst) {
  client_.sendGoal(goal("first"));
  Client second("/scan_cell/scan", false);
  ASSERT_TRUE(second.waitForServer(ros::Duration(20)));
  second.sendGoalAndWait(goal("second"), ros::Duration(10));
  EXPECT_EQ(second.getState().state_, State::REJECTED);
  EXPECT_NE(second.getResult()->message.find("'first' is running"), std::string::npos);
  ASSERT_TRUE(client_.waitForResult(ros::Duration(30)));
  EXPECT_EQ(client_.getState().state_, State::SUCCEEDED) << "the first goes on";
}

TEST_F(ScanClient, StopsTheRobotAndKeepsTheDataWhenCancelled) {
  start(client_, goal("cancelled"));
  client_.cancelGoal();
  ASSERT_TRUE(client_.waitForResult(ros::Duration(10)));
  EXPECT_EQ(client_.getState().state_, State::PREEMPTED);
  EXPECT_EQ(client_.getResult()->outcome, ScanResult::CANCELLED);
  EXPECT_TRUE(logged("disarmed"));
  EXPECT_TRUE(logged("stopped"));
  EXPECT_TRUE(logged("cloud partial"));
  EXPECT_FALSE(client_.getResult()->cloud.data.empty());
}

TEST_F(ScanClient, EndsWhenTheRobotTellsAnOldPose) {
  node_.setParam("/fake/silent", "pose");
  const ScanResult result = run(goal("old pose"));
  EXPECT_EQ(result.outcome, ScanResult::ROBOT_LOST) << result.message;
  EXPECT_NE(result.message.find("no new pose"), std::string::npos) << result.message;
  EXPECT_TRUE(logged("disarmed"));
}

TEST_F(ScanClient, EndsWithTheReasonWhenADeviceFallsSilent) {
  const std::vector<std::pair<std::string, int>> devices = {{"robot", ScanResult::ROBOT_LOST},
                                                            {"camera", ScanResult::CAMERA_LOST},
                                                            {"trigger", ScanResult::TRIGGER_LOST}};
  for (const auto& [device, outcome] : devices) {
    node_.setParam("/fake/silent", device);
    const ScanResult result = run(goal(device));
    EXPECT_EQ(result.outcome, outcome) << result.message;
    EXPECT_EQ(client_.getState().state_, State::ABORTED);
    EXPECT_EQ(result.message.find(device), 0U) << result.message;
    EXPECT_FALSE(result.cloud.data.empty());
  }
}

TEST_F(ScanClient, IsNotFinishedWhereTheCameraFallsSilentInTheLastMoment) {
  node_.setParam("/fake/binder", "no end");
  const ScanResult result = run(goal("no end"));
  EXPECT_EQ(result.outcome, ScanResult::CAMERA_LOST) << result.message;
  EXPECT_NE(result.message.find("no frame of the last"), std::string::npos) << result.message;
  EXPECT_TRUE(logged("cloud partial"));
}

TEST_F(ScanClient, IsNotFinishedWhereTheTriggerDoesNotAnswerAtTheEnd) {
  node_.setParam("/fake/hangs", "disarm");
  const ScanResult result = run(goal("not disarmed"));
  EXPECT_EQ(result.outcome, ScanResult::TRIGGER_LOST) << result.message;
  EXPECT_FALSE(result.cloud.data.empty());
}

TEST_F(ScanClient, StopsTheMovingRobotWhereTheTriggerHangsWhenArmed) {
  node_.setParam("/fake/hangs", "arm");
  node_.setParam("/fake/move_time", 4.0);
  const ScanResult result = run(goal("not armed"));
  EXPECT_EQ(result.outcome, ScanResult::TRIGGER_LOST) << result.message;
  EXPECT_TRUE(logged("stopped")) << "it drove to the end while the trigger was asked";
}

TEST_F(ScanClient, KeepsTheCloudWhereTheBinderFails) {
  node_.setParam("/fake/binder", "broken");
  const ScanResult result = run(goal("binder broken"));
  EXPECT_EQ(result.outcome, ScanResult::STAGE_FAILED);
  EXPECT_NE(result.message.find("/pose_frame_binder"), std::string::npos) << result.message;
  EXPECT_FALSE(result.cloud.data.empty());
  EXPECT_TRUE(logged("cloud partial"));
}

TEST_F(ScanClient, IsNotFinishedWhereNoFrameOfAPassWasBound) {
  node_.setParam("/fake/binder", "no pose");
  scan_cell_msgs::ScanGoal program = goal("pass not bound");
  program.passes.push_back(program.passes.front());
  program.passes[1].name = "flank";
  const ScanResult result = run(program);
  EXPECT_EQ(result.outcome, ScanResult::STAGE_FAILED) << result.message;
  EXPECT_EQ(result.message.find("pass 2 (flank): no frame of its "), 0U) << result.message;
  EXPECT_NE(result.message.find("no pose before it"), std::string::npos) << result.message;
  EXPECT_TRUE(logged("cloud partial"));
}

TEST_F(ScanClient, StopsWhereTheBinderDiesInMidScan) {
  using scan_cell_msgs::FinishBinding;
  using scan_cell_msgs::StartRun;
  using scan_cell_msgs::StartScan;
  bool (*start_run)(StartRun::Request&, StartRun::Response&) = [](auto&, auto& response) {
    response.success = true;
    return true;
  };
  bool (*start_binding)(StartScan::Request&, StartScan::Response&) = [](auto&, auto& response) {
    response.success = true;
    return true;
  };
  bool (*finish_binding)(FinishBinding::Request&, FinishBinding::Response&) = [](auto&, auto&) {
    return false;
  };
  ros::ServiceServer start_server = node_.advertiseService("/test_binder/start", start_binding);
  const ros::ServiceServer check_server =
      node_.advertiseService("/test_binder/check_run", start_run);
  const ros::ServiceServer run_server = node_.advertiseService("/test_binder/start_run", start_run);
  ros::ServiceServer finish_server = node_.advertiseService("/test_binder/finish", finish_binding);
  node_.setParam("/fake/move_time", 8.0);
  Client client("/cell_with_own_binder/scan", false);
  ASSERT_TRUE(client.waitForServer(ros::Duration(20)));
  start(client, goal("binder dies"));
  finish_server.shutdown();
  ASSERT_TRUE(client.waitForResult(ros::Duration(30)));
  EXPECT_EQ(client.getResult()->outcome, ScanResult::STAGE_FAILED);
  EXPECT_EQ(client.getResult()->message.find("/test_binder"), 0U) << client.getResult()->message;
  EXPECT_TRUE(logged("stopped")) << "the scan went on without its binder";
}

TEST_F(ScanClient, MakesTheCellSafeAndKeepsTheDataWhenTheNodeIsShutDownOverTheNetwork) {
  Client client("/cell_to_end/scan", false);
  ASSERT_TRUE(client.waitForServer(ros::Duration(20)));
  node_.setParam("/fake/move_time", 8.0);
  start(client, goal("node ends"));
  ASSERT_EQ(std::system("rosnode kill /cell_to_end"), 0);
  EXPECT_TRUE(logged("disarmed"));
  EXPECT_TRUE(logged("stopped"));
  ASSERT_TRUE(client.waitForResult(ros::Duration(30)));
  ASSERT_EQ(client.getState().state_, State::PREEMPTED);
  EXPECT_EQ(client.getResult()->outcome, ScanResult::CANCELLED);
  EXPECT_FALSE(client.getResult()->cloud.data.empty());
}

TEST_F(ScanClient, IsCancelledWhenItsToolIsInterruptedAndTheCloudIsSaved) {
  const fs::path output = fs::temp_directory_path() / ("tool_" + std::to_string(getpid()) + ".ply");
  node_.setParam("/fake/move_time", 8.0);
  ChildProcess tool({SCAN_TOOL, "--program", SCAN_PROGRAM, "--output", output.string()});
  ASSERT_TRUE(logged("armed"));
  kill(tool.id(), SIGINT);
  EXPECT_EQ(tool.wait(), 2);
  EXPECT_TRUE(logged("disarmed"));
  EXPECT_TRUE(logged("stopped"));
  EXPECT_TRUE(fs::remove(output)) << "what was captured must be saved";
}

TEST_F(ScanClient, LeavesTheCapturedCloudWhereItEndsEarlyAndACleanOneIsWanted) {
  const fs::path output =
      fs::temp_directory_path() / ("early_" + std::to_string(getpid()) + ".ply");
  node_.setParam("/fake/silent", "camera");
  ChildProcess tool(
      {SCAN_TOOL, "--program", SCAN_PROGRAM, "--output", output.string(), "--clean", "clean.ply"});
  EXPECT_EQ(tool.wait(), 2);
  EXPECT_TRUE(fs::remove(output)) << "what was captured must be saved";
}

TEST_F(ScanClient, IsNoSuccessWhereTheActionServerIsStartedAnew) {
  using Server = actionlib::ActionServer<scan_cell_msgs::ScanAction>;
  const auto nothing = [](Server::GoalHandle) {};
  std::promise<void> accepted;
  auto server = std::make_unique<Server>(
      node_, "/restarted/scan",
      [&](Server::GoalHandle handle) {
        handle.setAccepted();
        accepted.set_value();
      },
      nothing, false);
  server->start();
  scan_cell::CellClient::Names names;
  names.scan = "/restarted/scan";
  scan_cell::CellClient cell(node_, names);
  auto result = std::async(std::launch::async, [&] {
    return cell.scan(scan_cell::load_scan_program(SCAN_PROGRAM), "lost", 20,
                     [](const std::string&, double) {});
  });
  ASSERT_EQ(accepted.get_future().wait_for(std::chrono::seconds(30)), std::future_status::ready);
  server.reset();
  server = std::make_unique<Server>(node_, "/restarted/scan", nothing, nothing, false);
  server->start();
  EXPECT_THROW(result.get(), scan_cell_common::ConnectionError);
}

TEST_F(ScanClient, IsNoSuccessWhereTheActionServerNeverTakesTheGoal) {
  const auto nothing = [](actionlib::ActionServer<scan_cell_msgs::ScanAction>::GoalHandle) {};
  actionlib::ActionServer<scan_cell_msgs::ScanAction> server(node_, "/busy/scan", nothing, nothing,
                                                             false);
  server.start();
  scan_cell::CellClient::Names names;
  names.scan = "/busy/scan";
  scan_cell::CellClient cell(node_, names);
  EXPECT_THROW(cell.scan(scan_cell::load_scan_program(SCAN_PROGRAM), "untaken", 2,
                         [](const std::string&, double) {}),
               scan_cell_common::ConnectionError);
}

TEST_F(ScanClient, TellsARobotThatRefusesASpeedFromOneThatIsLost) {
  ros::param::set("/fake/speed", "refused");
  EXPECT_EQ(run(goal("refused")).outcome, ScanResult::MOTION_FAILED);
  ros::param::set("/fake/speed", "lost");
  EXPECT_EQ(run(goal("lost")).outcome, ScanResult::ROBOT_LOST);
}

TEST_F(ScanClient, RefusesWhatMakesNoSense) {
  scan_cell_msgs::ScanGoal bad = goal("bad");
  bad.frame = "no_such_frame";
  EXPECT_NE(run(bad).message.find("no_such_frame"), std::string::npos);
  EXPECT_EQ(client_.getState().state_, State::REJECTED);
  bad = goal("bad");
  bad.passes[0].poses[0].orientation.x = 0;
  EXPECT_NE(run(bad).message.find("quaternion"), std::string::npos);
  bad = goal("bad");
  bad.passes[0].speed = 9;
  EXPECT_NE(run(bad).message.find("speed"), std::string::npos);
}

TEST_F(ScanClient, RefusesALaserThatIsNotCalibratedByItsPassBeforeAnythingMoves) {
  ros::param::set("/fake/uncalibrated", 2);
  scan_cell_msgs::ScanGoal program = goal("not calibrated");
  program.passes.push_back(program.passes.front());
  program.passes[1].name = "flank";
  program.passes[1].lasers = scan_cell_msgs::ScanPass::ALTERNATE;
  const ScanResult result = run(program);
  EXPECT_EQ(result.outcome, ScanResult::REFUSED);
  EXPECT_EQ(result.message,
            "pass 2 (flank): refused by /laser_triangulation; laser mask 2 is not calibrated");
  EXPECT_EQ(result.audit.triggers, 0U);
}

TEST_F(ScanClient, RefusesLasersThatHaveNoTimeToTakeTurnsBeforeAnythingMoves) {
  ros::param::set("/fake/exposure", 0.03);
  scan_cell_msgs::ScanGoal program = goal("alternate");
  program.passes.push_back(program.passes.front());
  program.passes[1].lasers = scan_cell_msgs::ScanPass::ALTERNATE;
  const ScanResult result = run(program);
  EXPECT_EQ(result.outcome, ScanResult::REFUSED);
  EXPECT_EQ(result.message,
            "pass 2: trigger: arming refused; /laser_trigger/check_arm: refused; rate: 50 Hz "
            "to alternate");
  EXPECT_EQ(result.audit.triggers, 0U) << "the first pass was not begun";
}

TEST_F(ScanClient, SaysThatTheReachWasNotCheckedWhereTheDriverCannot) {
  const ScanResult result = run(goal("not checked"));
  EXPECT_EQ(result.outcome, ScanResult::FINISHED) << result.message;
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_NE(result.warnings[0].find("were not checked"), std::string::npos) << result.warnings[0];
}

TEST_F(ScanClient, TellsAProgramThatCannotBeScannedFromOneThatNobodyChecked) {
  const auto check = [](const std::string& cell) {
    ChildProcess tool({CHECK_PROGRAM_TOOL, "--program", SCAN_PROGRAM, "--cell", cell});
    return tool.wait();
  };
  EXPECT_EQ(check("/scan_cell"), 0);
  ros::param::set("/fake/uncalibrated", 1);
  EXPECT_EQ(check("/scan_cell"), 2);
  EXPECT_EQ(check("/cell_with_own_binder"), 1) << "there is no such binder";
}

TEST_F(ScanClient, RunsEachPassOfAProgramIntoOneCloud) {
  scan_cell_msgs::ScanGoal program = goal("program");
  program.passes.push_back(program.passes.front());
  program.passes[1].lasers = scan_cell_msgs::ScanPass::EACH;
  const ScanResult result = run(program);
  EXPECT_EQ(result.outcome, ScanResult::FINISHED) << result.message;
  EXPECT_EQ(result.passes_finished, 2U);
  ASSERT_TRUE(logged("cloud whole"));
  const std::lock_guard<std::mutex> lock(mutex_);
  EXPECT_EQ(std::count(log_.begin(), log_.end(), "armed"), 3) << "laser_0, then there and back";
  EXPECT_EQ(std::count(log_.begin(), log_.end(), "disarmed"), 3);
  EXPECT_EQ(std::count(log_.begin(), log_.end(), "cloud whole"), 1);
}

TEST_F(ScanClient, RecordsThePoseInWhichTheRobotStands) {
  const std::string file = (std::filesystem::temp_directory_path() / "recorded_poses.csv").string();
  std::filesystem::remove(file);
  const auto record = [](const std::string& path) {
    scan_cell_msgs::RecordPose::Request request;
    request.file = path;
    return scan_cell::ask<scan_cell_msgs::RecordPose>("/scan_cell/record_pose", request, 20);
  };
  ros::param::set("/fake/flange_x", 0.25);
  EXPECT_EQ(record(file).poses, 1U);
  ros::param::set("/fake/flange_x", 0.75);
  const auto answer = record(file);
  EXPECT_TRUE(answer.success) << answer.message;
  EXPECT_EQ(answer.poses, 2U);
  EXPECT_EQ(answer.pose.pose.position.x, 0.75);
  const auto taught = scan_calibration::load_taught_poses(file);
  EXPECT_EQ(taught.poses.at(0).translation().x(), 0.25);
  EXPECT_EQ(taught.poses.at(1).translation().x(), 0.75);

  EXPECT_NE(record(file).message.find("repeats the pose"), std::string::npos) << "the same pose";
  EXPECT_NE(record("poses.csv").message.find("absolute path"), std::string::npos);
  ros::param::set("/fake/moves", "yes");
  EXPECT_NE(record(file).message.find("moving"), std::string::npos);
  EXPECT_EQ(scan_calibration::load_taught_poses(file).poses.size(), 2U);
  std::filesystem::remove(file);
}

TEST_F(ScanClient, IsReachedByViDeE) {
  boost::asio::io_context context;
  boost::asio::ip::tcp::socket socket(context);
  boost::system::error_code error = boost::asio::error::not_connected;
  for (int i = 0; i < 400 && error; ++i) {  // until videe_node listens
    ros::WallDuration(0.05).sleep();
    socket.close();
    socket.connect({boost::asio::ip::make_address("127.0.0.1"), 5999}, error);
  }
  ASSERT_FALSE(error) << error.message();
  boost::asio::streambuf buffer;
  const auto ask = [&](const std::string& command) {
    boost::asio::write(socket, boost::asio::buffer(command + "\n"));
    boost::asio::read_until(socket, buffer, '\n');
    std::istream stream(&buffer);
    std::string line;
    std::getline(stream, line);
    return line;
  };
  EXPECT_EQ(ask("INIT_CYCLE"), "OK");
  EXPECT_EQ(ask("START_SCAN").substr(0, 5), "ERROR");
  EXPECT_EQ(ask("SET_POSITION 0,0,600,180,0,0 100,0,600,180,0,0"), "OK");
  EXPECT_EQ(ask("WAIT_SCAN").substr(0, 5), "ERROR");
  EXPECT_EQ(ask("START_SCAN"), "OK");
  EXPECT_EQ(ask("WAIT_SCAN"), "OK");
  const fs::path folder = ros::param::param<std::string>("/videe/cloud_folder", "");
  const fs::path away = folder.string() + "_away";
  fs::rename(folder, away);
  EXPECT_NE(ask("STOP_SCAN").find("then send STOP_SCAN again"), std::string::npos);
  fs::rename(away, folder);
  const std::string result = ask("STOP_SCAN");
  EXPECT_EQ(result.substr(0, 8), "OK scan=") << result;
  EXPECT_NE(result.find(" ended=whole "), std::string::npos) << result;
  EXPECT_EQ(ask("STOP_SCAN").substr(0, 5), "ERROR");
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_scan_action");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
