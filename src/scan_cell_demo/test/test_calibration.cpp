// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib/client/simple_action_client.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <ros/package.h>
#include <ros/ros.h>
#include <scan_cell_msgs/CalibrateAction.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <scan_cell_msgs/ScanAction.h>
#include <scan_cell_msgs/SetFaults.h>
#include <scan_cell_msgs/TriggerState.h>
#include <unistd.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <boost/asio.hpp>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <vector>

#include "laser_triangulation/scanner_model.h"
#include "scan_calibration/session.h"
#include "scan_cell/ros/cell_client.h"
#include "scan_cell/ros/service_call.h"

namespace fs = std::filesystem;

using laser_triangulation::LaserPlane;
using laser_triangulation::ScannerModel;
using scan_cell_msgs::CalibrateGoal;
using scan_cell_msgs::CalibrateResult;
using State = actionlib::SimpleClientGoalState;

namespace {

constexpr double kTimeout = 90;                                               // [s]
const char* const kVideePoses = "/tmp/scan_cell_test_calibration_poses.csv";  // calibration.test

std::string config(const std::string& name) {
  return ros::package::getPath("scan_cell_sim") + "/config/" + name;
}

/// The taught poses that are shipped, a line each.
std::vector<std::string> shipped_poses() {
  std::ifstream file(config("calibration_poses.csv"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line[0] != '#' && line[0] != 'x') lines.push_back(line);
  }
  return lines;
}

void write_poses(const std::string& path, const std::vector<std::string>& lines) {
  std::ofstream file(path);
  file << "x,y,z,qx,qy,qz,qw\n";
  for (const std::string& line : lines)
    file << line << '\n';
}

class Calibration : public testing::Test {
 protected:
  using Client = actionlib::SimpleActionClient<scan_cell_msgs::CalibrateAction>;

  Calibration() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Calibration() override { fs::remove_all(folder_); }

  void SetUp() override {
    ASSERT_TRUE(client_.waitForServer(ros::Duration(kTimeout)));
    trigger_ = node_.subscribe("/laser_trigger/state", 10, &Calibration::on_trigger, this);
    status_ = node_.subscribe("/c4g_driver/status", 10, &Calibration::on_status, this);
    wait_for("the robot", [this] { return connected_; });
    wait_for("the camera", [] { return ros::service::exists("/camera/set_parameters", false); });
    before_ = camera_settings();
  }

  /// However it ended: lasers off, robot still, camera as it was.
  void TearDown() override {
    scan_cell::call<scan_cell_msgs::SetFaults>("/scan_cell_sim/set_faults", {}, kTimeout);
    wait_for("the lasers to be off", [this] { return lasers_ == 0 && !armed_; });
    wait_for("the robot to stand", [this] { return !moving_; });
    EXPECT_EQ(camera_settings(), before_) << "region and exposure must be as before";
  }

  void on_trigger(const scan_cell_msgs::TriggerState& state) {
    const std::lock_guard<std::mutex> lock(mutex_);
    lasers_ = state.lasers;
    armed_ = state.armed;
    if (lasers_ != 0) lit_.push_back(lasers_);
    news_.notify_all();
  }

  void on_status(const scan_cell_msgs::RobotStatus& status) {
    const std::lock_guard<std::mutex> lock(mutex_);
    connected_ = status.connected;
    moving_ = status.in_motion == scan_cell_msgs::RobotStatus::YES;
    news_.notify_all();
  }

  void wait_for(const std::string& what, const std::function<bool()>& condition) {
    constexpr std::chrono::milliseconds kSlice(50);
    const auto deadline =
        std::chrono::steady_clock::now() + std::chrono::duration<double>(kTimeout);
    std::unique_lock<std::mutex> lock(mutex_);
    while (!condition()) {
      ASSERT_LT(std::chrono::steady_clock::now(), deadline) << what;
      news_.wait_for(lock, kSlice);
    }
  }

  static std::vector<double> camera_settings() {
    const auto config =
        scan_cell::ask<dynamic_reconfigure::Reconfigure>("/camera/set_parameters", {}, kTimeout)
            .config;
    std::vector<double> settings;
    for (const auto& value : config.ints)
      settings.push_back(value.value);
    for (const auto& value : config.doubles)
      settings.push_back(value.value);
    return settings;
  }

  CalibrateGoal goal(const std::string& name, const std::vector<std::string>& poses) const {
    CalibrateGoal goal;
    goal.poses = folder_ + "/" + name + ".csv";
    write_poses(goal.poses, poses);
    goal.session = folder_ + "/" + name;
    goal.board_columns = 15;
    goal.board_rows = 25;
    goal.square_size = 0.02;
    goal.lasers = 3;
    goal.board_exposure = 0.05;
    goal.line_exposure = 0.001;
    return goal;
  }

  /// Starts it and returns once this is being done.
  void start(const CalibrateGoal& goal, const std::string& doing) {
    const auto seen = std::make_shared<std::atomic<bool>>(false);
    client_.sendGoal(goal, Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                     [=](const scan_cell_msgs::CalibrateFeedbackConstPtr& feedback) {
                       if (feedback->doing == doing) *seen = true;
                     });
    wait_for(doing, [seen] { return seen->load(); });
  }

  CalibrateResult end() {
    EXPECT_TRUE(client_.waitForResult(ros::Duration(kTimeout)));
    return *client_.getResult();
  }

  const std::string folder_ =
      (fs::temp_directory_path() / ("calibration_" + std::to_string(getpid()))).string();
  ros::NodeHandle node_;
  Client client_{"/scan_cell/calibrate", false};
  std::vector<double> before_;
  ros::Subscriber trigger_;
  ros::Subscriber status_;
  std::mutex mutex_;
  std::condition_variable news_;
  int lasers_ = 0;
  bool armed_ = false;
  bool connected_ = false;
  bool moving_ = false;
  std::vector<int> lit_;  // masks, whenever a laser was on
};

/// Where the ray of a pixel meets the plane of light, in tool0 [m].
Eigen::Vector3d scanned(const ScannerModel& model, int laser, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d distorted((pixel.x() - model.camera.cx) / model.camera.fx,
                                  (pixel.y() - model.camera.cy) / model.camera.fy);
  Eigen::Vector2d ray = distorted;
  EXPECT_TRUE(model.camera.undistort(distorted, ray));
  const Eigen::Vector3d direction(ray.x(), ray.y(), 1);
  const LaserPlane& plane = model.lasers.at(static_cast<std::size_t>(laser));
  return model.flange_to_camera * (direction * (plane.distance / plane.normal.dot(direction)));
}

/// Greatest distance [m] between what the two make of the same peak, at 0.42 m to 0.62 m from the
/// camera and up to 0.2 m to its sides.
double worst_point(const ScannerModel& model, const ScannerModel& truth) {
  double worst = 0;
  for (int laser = 0; laser < 2; ++laser) {
    const LaserPlane& plane = truth.lasers[static_cast<std::size_t>(laser)];
    for (double z = 0.42; z <= 0.62; z += 0.02) {
      for (double y = -0.2; y <= 0.2; y += 0.02) {
        const double x =
            (plane.distance - plane.normal.y() * y - plane.normal.z() * z) / plane.normal.x();
        const Eigen::Vector2d pixel = truth.camera.project({x, y, z});
        worst =
            std::max(worst, (scanned(model, laser, pixel) - scanned(truth, laser, pixel)).norm());
      }
    }
  }
  return worst;
}

/// Where the camera sits on the flange, beside what the report says of how well it knows that. Five
/// deviations: a right covariance is beyond them once in a million.
void expect_within_stated_bounds(const std::string& report, const ScannerModel& truth) {
  const Eigen::AngleAxisd turn(truth.flange_to_camera.linear());
  const Eigen::Vector3d rotation = turn.angle() * turn.axis();
  const Eigen::Vector3d& translation = truth.flange_to_camera.translation();
  std::map<std::string, double> expected;
  const char* const axes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    expected[std::string("flange_to_camera.translation.") + axes[i]] = translation[i];
    expected[std::string("flange_to_camera.rotation_vector.") + axes[i]] = rotation[i];
  }
  std::ifstream file(report);
  const nlohmann::json judged = nlohmann::json::parse(file);
  for (const auto& parameter : judged.at("parameters")) {
    const auto found = expected.find(parameter.at("name").get<std::string>());
    if (found == expected.end()) continue;
    const double deviation = parameter.at("deviation");
    EXPECT_LT(deviation, 1e-4) << found->first << ": so wide a bound says nothing";
    EXPECT_LT(std::abs(parameter.at("value").get<double>() - found->second), 5 * deviation)
        << found->first;
    expected.erase(found);
  }
  EXPECT_TRUE(expected.empty()) << "the report lacks " << expected.begin()->first;
}

}  // namespace

TEST_F(Calibration, FindsTheSimulatorsTruthAndNamesTheUnreachablePose) {
  std::vector<std::string> poses;
  const std::vector<std::string> shipped = shipped_poses();
  for (std::size_t i = 0; i < shipped.size(); i += 2)
    poses.push_back(shipped[i]);
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

  const ScannerModel model = laser_triangulation::load_scanner_model(result.model);
  const ScannerModel truth = laser_triangulation::load_scanner_model(config("scanner.yaml"));
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
  bad.lasers = 0;
  refused(bad, "lasers");
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
