// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <scan_cell_msgs/ScanAction.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <boost/asio.hpp>

#include "calibration/calibrating_cell.h"
#include "scan_calibration/session.h"
#include "scan_cell/ros/cell_client.h"

using State = actionlib::SimpleClientGoalState;

namespace {

const char* const kVideePoses = "/tmp/scan_cell_test_calibration_poses.csv";  // calibration.test

}  // namespace

TEST_F(Calibration, FindsTheSimulatorsTruthAndNamesTheUnreachablePose) {
  std::vector<std::string> poses = some_poses(2);
  poses.insert(poses.begin() + 3, "1.9,0.0,0.2,1,0,0,0");  // beyond the arm
  CalibrateGoal wanted = goal("whole", poses);
  wanted.output = folder_ + "/scanner.yaml";
  ros::Subscriber markers;
  std::atomic<std::size_t> shown{0};
  const boost::function<void(const visualization_msgs::MarkerArrayConstPtr&)> count =
      [&](const visualization_msgs::MarkerArrayConstPtr& array) { shown = array->markers.size(); };
  markers = node_.subscribe<visualization_msgs::MarkerArray>("/scan_cell/calibration", 1, count);
  scan_cell::CellClient cell(node_, {});
  const CalibrateResult result = cell.calibrate(wanted, kTimeout, [](const auto&, double) {});

  ASSERT_EQ(result.outcome, CalibrateResult::FINISHED) << result.message;
  EXPECT_EQ(result.poses, poses.size());
  EXPECT_EQ(result.views, poses.size() - 1);
  ASSERT_EQ(result.skipped.size(), 1U);
  EXPECT_EQ(result.skipped[0].find("line 5: "), 0U) << result.skipped[0];
  EXPECT_EQ(result.model, wanted.output);
  EXPECT_TRUE(fs::is_regular_file(result.report));
  EXPECT_LT(result.held_out.reprojection_rms_px, 0.1586) << "the thesis' figure";

  const ScannerModel model = scan_cell_common::load_scanner_model(result.model);
  const ScannerModel truth = scan_cell_common::load_scanner_model(config("scanner.yaml"));
  EXPECT_LT(worst_point(model, truth), 0.0001);
  expect_within_stated_bounds(result.report, truth);
  wait_for("the markers", [&] { return shown > 2 * result.views; });
  EXPECT_TRUE(std::none_of(lit_.begin(), lit_.end(), [](int mask) { return mask == 3; }))
      << "the lasers must be on one at a time";
}

TEST_F(Calibration, RejectsAnotherGoalByTheNameOfWhatRunsAndEndsSafelyWhenCancelled) {
  const CalibrateGoal wanted = goal("cancelled", shipped_poses());
  start(wanted, "take an image of laser_1");
  Client second("/scan_cell/calibrate", false);
  ASSERT_TRUE(second.waitForServer(ros::Duration(kTimeout)));
  second.sendGoalAndWait(goal("second", shipped_poses()), ros::Duration(kTimeout));
  EXPECT_EQ(second.getState().state_, State::REJECTED);
  EXPECT_NE(second.getResult()->message.find("'" + wanted.session + "' is running"),
            std::string::npos)
      << second.getResult()->message;
  actionlib::SimpleActionClient<scan_cell_msgs::ScanAction> scan("/scan_cell/scan", false);
  ASSERT_TRUE(scan.waitForServer(ros::Duration(kTimeout)));
  scan.sendGoalAndWait(scan_cell_msgs::ScanGoal(), ros::Duration(kTimeout));
  EXPECT_EQ(scan.getState().state_, State::REJECTED);
  EXPECT_NE(scan.getResult()->message.find("calibration"), std::string::npos)
      << scan.getResult()->message;
  client_.cancelGoal();
  EXPECT_EQ(end().outcome, CalibrateResult::CANCELLED);
}

TEST_F(Calibration, KeepsWhatWasRecordedWhenCancelled) {
  const CalibrateGoal wanted = goal("kept", shipped_poses());
  std::atomic<bool> second_pose{false};
  client_.sendGoal(wanted, Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                   [&](const scan_cell_msgs::CalibrateFeedbackConstPtr& feedback) {
                     if (feedback->pose == 2 && feedback->doing != "move") second_pose = true;
                   });
  wait_for("the second pose", [&] { return second_pose.load(); });
  client_.cancelGoal();
  const CalibrateResult result = end();
  EXPECT_EQ(client_.getState().state_, State::PREEMPTED);
  EXPECT_EQ(result.outcome, CalibrateResult::CANCELLED);
  const auto session = scan_calibration::load_session(wanted.session);
  EXPECT_EQ(session.views.size(), result.views);
  EXPECT_GE(session.views.size(), 1U);
}

TEST_F(Calibration, EndsWhereTheCameraIsUnplugged) {
  const CalibrateGoal wanted = goal("unplugged", shipped_poses());
  start(wanted, "take an image of the board");
  scan_cell_msgs::SetFaults::Request faults;
  faults.camera_off = 1;
  scan_cell::call<scan_cell_msgs::SetFaults>("/scan_cell_sim/set_faults", faults, kTimeout);
  const CalibrateResult result = end();
  EXPECT_EQ(result.outcome, CalibrateResult::CAMERA_LOST) << result.message;
  EXPECT_EQ(result.message.find("camera"), 0U) << result.message;
}

TEST_F(Calibration, NeverMovesAgainAfterAnEmergencyStop) {
  const CalibrateGoal wanted = goal("stopped", shipped_poses());
  start(wanted, "move");
  wait_for("the motion", [this] { return moving_; });
  scan_cell_msgs::SetFaults::Request faults;
  faults.robot_e_stop = 1;
  scan_cell::call<scan_cell_msgs::SetFaults>("/scan_cell_sim/set_faults", faults, kTimeout);
  const CalibrateResult result = end();
  EXPECT_EQ(result.outcome, CalibrateResult::MOTION_FAILED) << result.message;
  EXPECT_TRUE(result.skipped.empty());
}

TEST_F(Calibration, RefusesWhatMakesNoSenseBeforeAnythingMoves) {
  const auto refused = [this](const CalibrateGoal& bad, const std::string& why) {
    client_.sendGoalAndWait(bad, ros::Duration(kTimeout));
    EXPECT_EQ(client_.getState().state_, State::REJECTED);
    EXPECT_EQ(client_.getResult()->outcome, CalibrateResult::REFUSED);
    EXPECT_NE(client_.getResult()->message.find(why), std::string::npos)
        << client_.getResult()->message;
  };
  CalibrateGoal bad = goal("no_poses", shipped_poses());
  bad.poses = folder_ + "/none.csv";
  refused(bad, "none.csv");
  bad = goal("no_lasers", shipped_poses());
  bad.lasers = 4;
  refused(bad, "lasers");
  bad = goal("nothing_to_keep", shipped_poses());
  bad.lasers_alone = 1;
  refused(bad, "no existing scanner model");
  bad.scanner = folder_ + "/none.yaml";
  refused(bad, "none.yaml");
  bad = goal("no_board", shipped_poses());
  bad.square_size = 20;
  refused(bad, "squares of 20");
  bad = goal("full", shipped_poses());
  fs::create_directories(bad.session);
  std::ofstream(bad.session + "/session.yaml") << "poses: poses.csv\n";
  refused(bad, "holds a session already");
}

TEST_F(Calibration, IsReachedByViDeE) {
  const std::vector<std::string> shipped = shipped_poses();
  write_poses(kVideePoses, {shipped.begin(), shipped.begin() + 2});
  boost::asio::io_context context;
  boost::asio::ip::tcp::socket socket(context);
  socket.connect({boost::asio::ip::make_address("127.0.0.1"), 5000});
  boost::asio::streambuf buffer;
  const auto ask = [&](const std::string& command) {
    boost::asio::write(socket, boost::asio::buffer(command + "\n"));
    boost::asio::read_until(socket, buffer, '\n');
    std::istream stream(&buffer);
    std::string line;
    std::getline(stream, line);
    return line;
  };
  EXPECT_EQ(ask("PERFORM_CALIBRATION").find("ERROR"), 0U) << "it was not prepared";
  EXPECT_EQ(ask("INIT_CALIBRATION"), "OK poses=2");
  const std::string answer = ask("PERFORM_CALIBRATION");
  ASSERT_EQ(answer.find("OK session="), 0U) << answer;
  EXPECT_NE(answer.find(" views=2 skipped=0"), std::string::npos) << answer;
  const std::string session = answer.substr(11, answer.find(' ', 11) - 11);
  EXPECT_EQ(scan_calibration::load_session(session).views.size(), 2U);
  fs::remove_all(session);
  fs::remove(kVideePoses);
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_calibration");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
