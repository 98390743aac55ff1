// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_msgs/CheckFollow.h>
#include <scan_cell_msgs/FollowAction.h>
#include <scan_cell_msgs/MoveAction.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <scan_cell_msgs/SetAcquisition.h>
#include <scan_cell_msgs/TriggerEvent.h>
#include <scan_cell_msgs/TriggerState.h>
#include <tf2_msgs/TFMessage.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <string>

#include "devices/last_heard.h"
#include "parameters/parameters.h"
#include "scan_cell_common/ros/goal_client.h"
#include "sequence/devices.h"
#include "work/follower.h"

namespace scan_cell {

scan_cell_msgs::FollowWaypoint message_of(const WorkWaypoint& waypoint);

/// The robot behind a node with c4g_driver's interface.
class RosRobot : public Robot, public Follower {
 public:
  RosRobot(ros::NodeHandle node, const Parameters& parameters);

  std::string trouble() const override;
  void set_linear_motion(double speed) override;
  std::optional<MovesCheck> check(const std::vector<PlannedMove>& moves) override;
  void start_move(const MoveTarget& target, double camera_rate) override;
  Motion motion() const override;
  std::string unseen() const override;
  std::string hindrance() const override;
  Eigen::Isometry3d static_pose() override;
  void stop() noexcept override;

  FollowCheck check_follow(const WorkPlan& plan) override;
  /// Everything that the driver says about a path. @throw scan_cell_common::Error if it cannot tell
  scan_cell_msgs::CheckFollow::Response ask_about(const WorkPlan& plan) const;
  void set_joint_speed(double share) override;
  void restore_speed() noexcept override;
  void start_joints(const std::vector<double>& joints) override;
  void start_follow(const WorkPlan& plan) override;
  std::size_t passed() const override;

  /// Drops goals sent to the robot before this object was created, by an earlier instance of this
  /// node: nobody watches over them.
  /// @return false if the driver is not there yet: call again
  bool drop_earlier_goals();

 private:
  scan_cell_msgs::MoveGoal goal_of(const MoveTarget& target, double camera_rate) const;
  scan_cell_msgs::FollowGoal goal_of(const WorkPlan& plan) const;
  void set_override(double percent) const;
  std::uint64_t begin_motion();
  void send(const scan_cell_msgs::MoveGoal& goal);
  void end_motion(std::uint64_t move, const actionlib::TerminalState& state, const Motion& told);
  void on_status(const scan_cell_msgs::RobotStatus& status);
  void on_transforms(const tf2_msgs::TFMessage& transforms);
  void on_feedback(std::uint64_t move, double progress, std::size_t passed);

  const Parameters parameters_;
  const ros::Time made_ = ros::Time::now();
  LastHeard status_;
  LastHeard pose_;       // status with a pose newer than the one before
  LastHeard transform_;  // of the flange
  mutable std::mutex mutex_;
  scan_cell_msgs::RobotStatus last_status_;
  std::optional<double> override_before_;  // [%] set while set_joint_speed() is in force
  Motion motion_;
  std::uint64_t move_ = 0;  // number of the present motion; late news of earlier ones is ignored
  std::size_t passed_ = 0;  // waypoints of the path being followed
  // Last, like the subscribers: their callbacks use the other members.
  scan_cell_common::GoalClient<scan_cell_msgs::MoveAction> move_client_;
  scan_cell_common::GoalClient<scan_cell_msgs::FollowAction> follow_client_;
  ros::Subscriber status_subscriber_;
  ros::Subscriber transform_subscriber_;
};

/// The camera behind a node with tecnogamma_camera's interface.
class RosCamera : public Camera {
 public:
  RosCamera(ros::NodeHandle node, const Parameters& parameters);

  std::string trouble() const override;
  void start(const PassCamera& settings) override;
  double exposure() const override { return exposure_; }
  void expect_profiles(double rate) override;
  void stop() noexcept override;
  std::string restore() noexcept override;

  /// Profiles since clear().
  std::uint64_t profiles() const { return profiles_; }
  void clear() { profiles_ = 0; }

 private:
  using Settings = scan_cell_msgs::CameraSettings;

  scan_cell_msgs::SetAcquisition::Response set_acquisition(
      std::uint8_t mode, double timeout, const std::optional<Settings>& settings = {}) const;
  Settings changed_to(const PassCamera& settings) const;
  void wait_for_late_profiles() const;

  const Parameters parameters_;
  LastHeard profile_;
  std::optional<Settings> before_;  // a pass had its own; none: nothing to restore
  double exposure_ = 0;             // [s]
  std::atomic<std::uint64_t> profiles_{0};
  std::atomic<double> silence_allowed_{0};  // [s]; 0: nothing is expected
  ros::Subscriber subscriber_;              // last, since its callbacks use the other members
};

/// The trigger circuit behind a node with laser_trigger's interface.
class RosTrigger : public Trigger {
 public:
  RosTrigger(ros::NodeHandle node, const Parameters& parameters);

  std::string trouble() const override;
  bool check(double rate, const Lighting& lighting) override;
  void arm(double rate, const Lighting& lighting) override;
  Disarmed disarm() noexcept override;
  void keep_alive() override;

 private:
  void on_event(const scan_cell_msgs::TriggerEvent& event);
  void on_state(const scan_cell_msgs::TriggerState& state);

  const Parameters parameters_;
  ros::Publisher keep_alive_publisher_;
  LastHeard event_;
  mutable std::mutex mutex_;
  std::uint32_t arming_ = 0;          // our arming; 0: none
  std::uint64_t pulses_ = 0;          // events received in it
  std::string disarmed_because_;      // the node's message when it disarmed by itself
  double silence_allowed_ = 0;        // [s]
  ros::Subscriber event_subscriber_;  // last, like the other: their callbacks use all members
  ros::Subscriber state_subscriber_;
};

}  // namespace scan_cell
