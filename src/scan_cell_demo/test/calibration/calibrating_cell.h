// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <ros/package.h>
#include <ros/ros.h>
#include <scan_cell_msgs/CalibrateAction.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <scan_cell_msgs/SetFaults.h>
#include <scan_cell_msgs/TriggerState.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <vector>

#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace fs = std::filesystem;

using scan_cell_common::LaserPlane;
using scan_cell_common::ScannerModel;
using scan_cell_msgs::CalibrateGoal;
using scan_cell_msgs::CalibrateResult;

constexpr double kTimeout = 90;  // [s]

inline std::string config(const std::string& name) {
  return ros::package::getPath("scan_cell_sim") + "/config/" + name;
}

/// The shipped taught poses, one per line.
inline std::vector<std::string> shipped_poses() {
  std::ifstream file(config("calibration_poses.csv"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line[0] != '#' && line[0] != 'x') lines.push_back(line);
  }
  return lines;
}

/// Every `step`-th of them.
inline std::vector<std::string> some_poses(std::size_t step) {
  std::vector<std::string> poses;
  const std::vector<std::string> shipped = shipped_poses();
  for (std::size_t i = 0; i < shipped.size(); i += step)
    poses.push_back(shipped[i]);
  return poses;
}

inline void write_poses(const std::string& path, const std::vector<std::string>& lines) {
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

  /// In any case the lasers end up off, the robot still, and the camera as it was.
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

  /// Starts a calibration and returns once `doing` is under way.
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
  std::mutex mutex_;
  std::condition_variable news_;
  int lasers_ = 0;
  bool armed_ = false;
  bool connected_ = false;
  bool moving_ = false;
  std::vector<int> lit_;  // masks, at each time a laser was on
  // last: their callbacks use all other members
  ros::Subscriber trigger_;
  ros::Subscriber status_;
};

/// Where the ray of a pixel meets the plane of light, in tool0 [m].
inline Eigen::Vector3d scanned(const ScannerModel& model, int laser, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d distorted((pixel.x() - model.camera.cx) / model.camera.fx,
                                  (pixel.y() - model.camera.cy) / model.camera.fy);
  Eigen::Vector2d ray = distorted;
  EXPECT_TRUE(model.camera.undistort(distorted, ray));
  const Eigen::Vector3d direction(ray.x(), ray.y(), 1);
  const LaserPlane& plane = model.laser(static_cast<std::size_t>(laser));
  return model.flange_to_camera * (direction * (plane.distance / plane.normal.dot(direction)));
}

/// Greatest distance [m] between the points that the two models give for the same peak, at 0.42 m
/// to 0.62 m from the camera and up to 0.2 m to its sides.
inline double worst_point(const ScannerModel& model, const ScannerModel& truth) {
  double worst = 0;
  for (int laser = 0; laser < 2; ++laser) {
    const LaserPlane& plane = truth.laser(static_cast<std::size_t>(laser));
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

/// Compares the camera's pose on the flange with the uncertainty stated in the report, within five
/// deviations: a correct covariance exceeds them once in a million.
inline void expect_within_stated_bounds(const std::string& report, const ScannerModel& truth) {
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
