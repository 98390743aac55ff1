// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib/client/simple_action_client.h>
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <ros/package.h>
#include <ros/ros.h>
#include <scan_cell_msgs/ArmTrigger.h>
#include <scan_cell_msgs/DisarmTrigger.h>
#include <scan_cell_msgs/LoadWorld.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <scan_cell_msgs/ScanAction.h>
#include <scan_cell_msgs/SetAcquisition.h>
#include <scan_cell_msgs/SetFaults.h>
#include <scan_cell_msgs/TriggerEvent.h>
#include <scan_cell_msgs/TriggerState.h>
#include <std_msgs/Empty.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdlib>
#include <functional>
#include <mutex>

#include "scan_cell/ros/cell_client.h"
#include "scan_cell/ros/scan_goal.h"
#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/ros/cloud_messages.h"
#include "scan_cell_common/ros/conversions.h"
#include "scan_cell_demo/comparison.h"
#include "scan_cell_sim/cell.h"
#include "tool_path_stretcher/ros/conversions.h"

using scan_cell_msgs::PeakProfile;
using scan_cell_msgs::ScanResult;
using scan_cell_msgs::SetAcquisition;
using scan_cell_msgs::SetFaults;

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr double kSafe = 6.0;  // [s] everything is several times slower
#else
constexpr double kSafe = 2.0;  // [s]
#endif

constexpr double kTimeout = 90;  // [s]

std::string config(const std::string& name) {
  return ros::package::getPath("scan_cell_sim") + "/config/" + name;
}

void ignore_progress(const std::string&, double) {}

class WholeCell : public testing::Test {
 protected:
  using Client = actionlib::SimpleActionClient<scan_cell_msgs::ScanAction>;

  void SetUp() override {
    ASSERT_TRUE(ros::service::waitForService("/scan_cell_sim/load_world", ros::Duration(kTimeout)));
    ASSERT_TRUE(scan_.waitForServer(ros::Duration(kTimeout)));
    trigger_ = node_.subscribe("/laser_trigger/state", 10, &WholeCell::on_trigger, this);
    status_ = node_.subscribe("/c4g_driver/status", 10, &WholeCell::on_status, this);
    flange_ = node_.subscribe("/scan_cell_sim/true_flange", 10, &WholeCell::on_flange, this);
    profiles_ = node_.subscribe("/camera/profiles", 1000, &WholeCell::on_profile, this);
    set_faults([](SetFaults::Request&) {});
    wait_for("the robot", [this] { return connected_; });
  }

  void TearDown() override {
    set_faults([](SetFaults::Request&) {});
    wait_for("the lasers to be off", [this] { return lasers_ == 0; });
    EXPECT_EQ(lit_rows(), 0);
  }

  void on_trigger(const scan_cell_msgs::TriggerState& state) {
    const std::lock_guard<std::mutex> lock(mutex_);
    lasers_ = state.lasers;
    news_.notify_all();
  }

  void on_status(const scan_cell_msgs::RobotStatus& status) {
    const std::lock_guard<std::mutex> lock(mutex_);
    connected_ = status.connected;
    moving_ = status.in_motion == scan_cell_msgs::RobotStatus::YES;
    news_.notify_all();
  }

  void on_flange(const geometry_msgs::PoseStamped& flange) {
    constexpr double kStill = 1e-5;  // [m]
    const std::lock_guard<std::mutex> lock(mutex_);
    const Eigen::Vector3d place =
        (base_link_ * scan_cell_common::from_ros(flange.pose)).translation();
    still_ = (place - place_).norm() < kStill ? still_ + 1 : 0;
    place_ = place;
    news_.notify_all();
  }

  void on_profile(const PeakProfile& profile) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (profile.acquisition != watched_) return;
    ++seen_;
    lit_rows_ += std::count_if(profile.position.begin(), profile.position.end(),
                               [](float position) { return std::isfinite(position); });
    news_.notify_all();
  }

  void wait_for(const std::string& what, const std::function<bool()>& condition) {
    std::unique_lock<std::mutex> lock(mutex_);
    EXPECT_TRUE(news_.wait_for(lock, std::chrono::duration<double>(kTimeout), condition)) << what;
  }

  static void set_faults(const std::function<void(SetFaults::Request&)>& change) {
    SetFaults::Request request;
    change(request);
    scan_cell::call<SetFaults>("/scan_cell_sim/set_faults", request, kTimeout);
  }

  sensor_msgs::PointCloud2 scan_world(const std::string& world, ScanResult& result) {
    scan_cell_msgs::LoadWorld::Request request;
    request.path = config(world);
    scan_cell::call<scan_cell_msgs::LoadWorld>("/scan_cell_sim/load_world", request, kTimeout);
    return cell_.scan_clean(program_, world, kTimeout, ignore_progress, result);
  }

  /// Scans again if a busy computer slowed the simulated robot down: without its poses the cloud
  /// has a hole of centimetres, across which no orientation is known.
  sensor_msgs::PointCloud2 scan_without_holes(const std::string& world, ScanResult& result) {
    constexpr double kHeldUp = 0.99;  // of the pulses
    constexpr int kTries = 4;
    sensor_msgs::PointCloud2 cloud;
    for (int i = 0; i < kTries; ++i) {
      cloud = scan_world(world, result);
      const auto bound = static_cast<double>(result.audit.frames_bound);
      if (bound >= kHeldUp * static_cast<double>(result.audit.triggers)) break;
    }
    return cloud;
  }

  /// Starts a scan and waits until its frames arrive.
  void start_scan(const std::string& scan_id) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      frames_ = 0;
    }
    scan_.sendGoal(scan_cell::scan_goal(program_, scan_id), Client::SimpleDoneCallback(),
                   Client::SimpleActiveCallback(),
                   [this](const scan_cell_msgs::ScanFeedbackConstPtr& feedback) {
                     const std::lock_guard<std::mutex> lock(mutex_);
                     frames_ = feedback->frames;
                     news_.notify_all();
                   });
    wait_for("frames", [this] { return frames_ > 50; });
  }

  /// Waits for the end of the disturbed scan.
  /// @return duration in seconds
  double wait_for_end() {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_TRUE(scan_.waitForResult(ros::Duration(kTimeout)));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  void expect_kept(const ScanResult& result) const {
    EXPECT_GT(result.audit.frames_bound, 20U);
    EXPECT_GT(result.statistics.points, 1000U) << "what was captured must be kept";
    EXPECT_EQ(result.cloud.width * result.cloud.height, result.statistics.points);
  }

  /// By the simulator's ground truth; a robot that had continued would be at the end of its line.
  void expect_standing_on_the_way() {
    constexpr double kMinWayLeft = 0.05;  // [m]
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      still_ = 0;
    }
    wait_for("the flange to stand", [this] { return still_ >= 3; });
    wait_for("the driver to say so", [this] { return !moving_; });
    const std::lock_guard<std::mutex> lock(mutex_);
    EXPECT_GT((program_.passes.front().poses.back().translation() - place_).norm(), kMinWayLeft);
  }

  /// Rows that show a laser line: the circuit's true state, whatever the trigger's node reports.
  long lit_rows() {
    SetAcquisition::Request request;
    request.mode = SetAcquisition::Request::RELIEF_ONLY;
    request.trigger = SetAcquisition::Request::FREE_RUN;
    const std::uint32_t started = set_acquisition(request);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      watched_ = started;
      seen_ = lit_rows_ = 0;
    }
    wait_for("frames in free run", [this] { return seen_ >= 3; });
    request.mode = SetAcquisition::Request::STOP;
    set_acquisition(request);
    const std::lock_guard<std::mutex> lock(mutex_);
    return lit_rows_;
  }

  /// Retries: a camera that was unplugged needs time.
  static std::uint32_t set_acquisition(const SetAcquisition::Request& request) {
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kTimeout);
    while (true) {
      const auto answer =
          scan_cell::ask<SetAcquisition>("/camera/set_acquisition", request, kTimeout);
      if (answer.success || ros::WallTime::now() > deadline) {
        EXPECT_TRUE(answer.success) << answer.message;
        return answer.acquisition;
      }
    }
  }

  static void expect_every_frame_accounted_for(const scan_cell_msgs::BindingAudit& audit) {
    EXPECT_EQ(audit.frames_bound + audit.frames_dropped, audit.frames);
    EXPECT_EQ(audit.dropped.size(), audit.frames_dropped + audit.frames_never_arrived);
    EXPECT_GE(audit.frames_bound + audit.dropped.size(), audit.triggers);
  }

  ros::NodeHandle node_;
  Client scan_{"/scan_cell/scan", false};
  scan_cell::CellClient cell_{node_, {}};
  const scan_cell::ScanProgram program_ =
      scan_cell::load_scan_program(ros::package::getPath("scan_cell") + "/config/scan_line.yaml");
  const Eigen::Isometry3d base_link_ = scan_cell_sim::load_base_link_in_world(config("cell.yaml"));
  std::mutex mutex_;
  std::condition_variable news_;
  int lasers_ = -1;
  bool connected_ = false;
  bool moving_ = false;
  std::uint64_t frames_ = 0;
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero();  // of the flange, in world
  int still_ = 0;                                    // messages in which it did not move
  std::uint32_t watched_ = 0;                        // acquisition
  int seen_ = 0;                                     // profiles of it
  long lit_rows_ = 0;                                // in them

  ros::Subscriber trigger_;  // after what their callbacks use
  ros::Subscriber status_;
  ros::Subscriber flange_;
  ros::Subscriber profiles_;
};

}  // namespace

TEST_F(WholeCell, AdaptsAPathToAScaledAndTurnedPartAsTheTruthSays) {
  ScanResult first;
  ScanResult second;
  const auto reference = scan_without_holes("reference_frame.yaml", first);
  const auto object = scan_without_holes("scaled_frame.yaml", second);
  for (const ScanResult& result : {first, second}) {
    expect_every_frame_accounted_for(result.audit);
    EXPECT_GT(result.audit.frames_bound, 0.95 * static_cast<double>(result.audit.triggers));
  }
  EXPECT_LE(scan_cell_demo::cloud_error(scan_cell_common::from_message(reference),
                                        config("reference_frame.yaml"))
                .rms,
            0.3e-3);
  EXPECT_LE(scan_cell_demo::cloud_error(scan_cell_common::from_message(object),
                                        config("scaled_frame.yaml"))
                .rms,
            0.3e-3);

  const auto path = scan_cell_demo::proven_path(config("reference_frame.yaml"), "frame");
  scan_cell_msgs::StretchToolPathGoal goal;
  goal.reference = reference;
  goal.object = object;
  goal.path = tool_path_stretcher::to_message(path, reference.header);
  const auto result = cell_.stretch(goal, kTimeout, ignore_progress);
  ASSERT_EQ(result.verdict.reason, scan_cell_msgs::StretchVerdict::ACCEPTED)
      << result.verdict.message;
  const auto truth = scan_cell_demo::true_path(path, config("reference_frame.yaml"),
                                               config("scaled_frame.yaml"), "frame");
  const auto error = scan_cell_demo::compare(tool_path_stretcher::from_message(result.path), truth);
  EXPECT_LE(error.rms, 1.0e-3);
  EXPECT_LE(error.orientation_rms, 3 * M_PI / 180);
}

TEST_F(WholeCell, AccountsForLostFramesAndBadPoses) {
  set_faults([](SetFaults::Request& faults) {
    faults.camera_lost_frames = 0.05;
    faults.robot_lost_packets = 0.1;
    faults.robot_repeated_packets = 0.1;
    faults.robot_delayed_packets = 0.1;
    faults.seed = 3;
  });
  ScanResult result;
  const auto cloud = scan_world("reference_frame.yaml", result);
  expect_every_frame_accounted_for(result.audit);
  EXPECT_GT(result.audit.frames_never_arrived, 5U);
  EXPECT_LE(scan_cell_demo::cloud_error(scan_cell_common::from_message(cloud),
                                        config("reference_frame.yaml"))
                .rms,
            0.3e-3)
      << "a wrong pairing would smear the cloud";
}

TEST_F(WholeCell, EndsWithinTwoSecondsWhenTheCameraIsUnplugged) {
  start_scan("camera unplugged");
  set_faults([](SetFaults::Request& faults) { faults.camera_off = true; });
  EXPECT_LT(wait_for_end(), kSafe);
  EXPECT_EQ(scan_.getResult()->outcome, ScanResult::CAMERA_LOST) << scan_.getResult()->message;
  expect_kept(*scan_.getResult());
  expect_standing_on_the_way();
}

TEST_F(WholeCell, EndsWithinTwoSecondsWhenTheControllerIsLostAndNeverResumes) {
  start_scan("link down");
  set_faults([](SetFaults::Request& faults) { faults.robot_link_down = true; });
  EXPECT_LT(wait_for_end(), kSafe);
  EXPECT_EQ(scan_.getResult()->outcome, ScanResult::ROBOT_LOST) << scan_.getResult()->message;
  expect_kept(*scan_.getResult());
  set_faults([](SetFaults::Request&) {});
  wait_for("the link", [this] { return connected_; });
  expect_standing_on_the_way();
}

TEST_F(WholeCell, EndsWithinTwoSecondsWhenTheTriggerDies) {
  start_scan("trigger killed");
  ASSERT_EQ(std::system("rosnode kill /laser_trigger > /dev/null"), 0);
  EXPECT_LT(wait_for_end(), kSafe);
  EXPECT_EQ(scan_.getResult()->outcome, ScanResult::TRIGGER_LOST) << scan_.getResult()->message;
  expect_kept(*scan_.getResult());
  expect_standing_on_the_way();
  ASSERT_TRUE(ros::service::waitForService("/laser_trigger/arm", ros::Duration(kTimeout)));
}

TEST_F(WholeCell, EndsWithinTwoSecondsWhenTheTriggerCircuitIsLost) {
  start_scan("circuit lost");
  set_faults([](SetFaults::Request& faults) { faults.trigger_circuit_lost = true; });
  EXPECT_LT(wait_for_end(), kSafe);
  EXPECT_EQ(scan_.getResult()->outcome, ScanResult::TRIGGER_LOST) << scan_.getResult()->message;
  EXPECT_NE(scan_.getResult()->message.find("trigger circuit"), std::string::npos)
      << scan_.getResult()->message;
  expect_kept(*scan_.getResult());
  expect_standing_on_the_way();
}

TEST_F(WholeCell, ShowsTheCameraALaserThatIsOn) {
  const ros::Publisher watcher = node_.advertise<std_msgs::Empty>("/laser_trigger/keep_alive", 1);
  const ros::WallTimer watching = node_.createWallTimer(
      ros::WallDuration(0.05),
      [&](const ros::WallTimerEvent&) { watcher.publish(std_msgs::Empty()); });
  scan_cell_msgs::ArmTrigger::Request arm;
  arm.rate = 10;
  arm.lasers = scan_cell_msgs::TriggerEvent::LASER_0;
  scan_cell::call<scan_cell_msgs::ArmTrigger>("/laser_trigger/arm", arm, kTimeout);
  EXPECT_GT(lit_rows(), 0) << "or no other test would see one that was left on";
  scan_cell::call<scan_cell_msgs::DisarmTrigger>("/laser_trigger/disarm", {}, kTimeout);
}

TEST_F(WholeCell, RejectsASecondScanAndStopsWhenCancelled) {
  start_scan("first");
  Client second("/scan_cell/scan", false);
  ASSERT_TRUE(second.waitForServer(ros::Duration(kTimeout)));
  second.sendGoal(scan_cell_msgs::ScanGoal());
  ASSERT_TRUE(second.waitForResult(ros::Duration(kTimeout)));
  EXPECT_NE(second.getResult()->message.find("'first' is running"), std::string::npos);
  scan_.cancelGoal();
  wait_for_end();
  EXPECT_EQ(scan_.getResult()->outcome, ScanResult::CANCELLED);
  expect_kept(*scan_.getResult());
  expect_standing_on_the_way();
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_whole_cell");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
