// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "c4g_driver/goal.h"
#include "c4g_driver/jog.h"
#include "c4g_driver/limits.h"
#include "c4g_driver/link_report.h"
#include "c4g_driver/motion_plan.h"
#include "c4g_driver/tool_motion_check.h"

namespace c4g_driver {

class Link;

/// Where the controller is, and what the client holds a motion to.
struct ClientOptions {
  std::string local_address = "0.0.0.0";  //!< IPv4 of this machine's interface to it; 0.0.0.0: any
  std::string address = "127.0.0.1";      //!< IPv4 of the controller
  std::uint16_t port = 5410;              //!< UDP, of the controller
  double link_timeout = 0.5;   //!< [s] no answer, or no fresh pose, for so long is a lost link
  int tries = 10;              //!< how often a request is sent within link_timeout
  double poll_period = 0.1;    //!< [s] between requests for the pose; they keep the session alive
  double follow_watch = 0.08;  //!< [s] of our silence after which the controller ends a path of the
                               //!< tool; requests come ten times as often then
  double reconnect_period =
      0.5;                    //!< [s] between attempts to connect; the first follows a loss at once
  double clock_window = 2.0;  //!< [s] over which the least delay of the wire is sought
  int realtime_priority = 0;  //!< of the receiving thread, SCHED_FIFO; 0: the usual scheduling
  std::shared_ptr<const RobotModel> robot;  //!< required
  RobotLimits limits;                       //!< that every motion is checked against
  ArrivalTolerance arrival;                 //!< what counts as arrived
  ToolCheckParameters tool_check;           //!< how a path of the tool is checked
};

/// The driver's side of c4g_protocol.md. Connects by itself and again after a loss, keeps the
/// session alive, and hands on every measured pose once, in the order of time.
///
/// A lost link drops the goal: nothing of it is sent again, and the new session makes the
/// controller forget what was on its way. All methods are safe to call from any thread. Requests
/// throw
/// - scan_cell_common::Refused if limits or controller refuse; nothing was done then,
/// - scan_cell_common::ConnectionError if there is no link, or it was lost over the request.
class Client {
 public:
  /// Called from the client's own thread; must not call the client's requests.
  using Listener = std::function<void(const MeasuredState&)>;

  /// @throw scan_cell_common::InvalidParameter if an option makes no sense, or is not allowed
  Client(const ClientOptions& options, Listener listener);

  /// Stops the robot if a goal is under way, and closes the session.
  ~Client();

  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// Starts a motion if the robot can carry it out; it is sent to the controller once, however
  /// often the packet is.
  void move(const Motion& motion);
  /// @throw as move()
  void move_to_pose(const Eigen::Isometry3d& flange, double camera_rate);
  /// Along the circle through `via`, with its orientation there. @throw as move()
  void move_along_arc(const Eigen::Isometry3d& via, const Eigen::Isometry3d& flange,
                      double camera_rate);
  /// Moves all axes together to six joints [rad]. @throw as move()
  void move_to_joints(const std::vector<double>& joints, double camera_rate);

  /// Starts to move one way, as far as the robot can within half a metre or a quarter turn: who
  /// wants it to go less far stops it. @throw as move(), if it cannot move that way at all
  void jog(const Jog& jog);

  /// Follows a path of the tool if the robot can; it is checked first, then loaded, and begun when
  /// the controller has confirmed all of it. The tip stands at the waypoint to begin with.
  /// @param from waypoint to begin with, counted from 0; 0: the whole path
  /// @param go_on asked while the path is loaded; where it says no, nothing moves
  /// @throw as move(); scan_cell_common::UnusableInput if the path is none
  void follow(const ToolMotion& motion, std::size_t from = 0,
              const std::function<bool()>& go_on = nullptr);

  /// Whether the robot could follow a path; nothing moves.
  /// @param from as of follow()
  /// @param joints six [rad], where the robot comes from; empty: where it stands
  /// @return counted from `from`
  ToolCheck check(const ToolMotion& motion, std::size_t from, const std::vector<double>& joints);

  /// Whether the robot could carry out motions one after the other; nothing moves. From where it
  /// stands: where a motion is under way, or still brakes, its end is awaited for up to 0.5 s.
  /// @param linear poses are gone to along lines, whatever is set on the controller
  /// @param joints six [rad], where the first one starts; empty: where the robot stands
  PlanCheck check(const std::vector<PlannedMotion>& plan, bool linear,
                  const std::vector<double>& joints);

  /// The robot brakes; wait_for_goal() tells when it stands.
  void stop();

  /// @param percent of the programmed speed, above 0, up to 100
  void set_override(double percent);
  void set_linear_speed(double speed);  //!< [m/s]
  void set_drives(bool on);             //!< the controller must be in mode remote
  void reset_alarms();                  //!< the controller must be in mode remote
  /// @return JSON in the controller's units, as c4g_protocol.md lists it
  std::string get_parameter(const std::string& name);
  /// @param json value in the controller's units, as c4g_protocol.md lists it
  void set_parameter(const std::string& name, const std::string& json);

  /// @throw scan_cell_common::Refused if the robot moves
  MeasuredState static_pose();

  /// Of the controller, for messages: with its address and port.
  const std::string& name() const;

  Goal goal() const;  //!< the latest one

  /// The goal as soon as it ended, or as it is after `timeout` [s].
  Goal wait_for_goal(double timeout) const;

  /// Whether there is a link now, or comes within `timeout` [s].
  bool wait_for_link(double timeout) const;

  std::optional<MeasuredState> latest() const;  //!< none before the first answer
  LinkReport link() const;                      //!< of this moment

 private:
  /// Sends what `choose` takes of the check of motions from where the robot stands.
  template <class Choose>
  void begin(bool in_joints, const Choose& choose);
  RobotState current() const;
  RobotState standing() const;
  MotionSettings settings_in_force();
  SpeedLimit speed_limit() const;
  ToolCheck check_path(const ToolMotion& motion, std::size_t from, const RobotState& state);

  const ClientOptions options_;
  std::uint64_t paths_ = 0;    // loaded; under settings_mutex_
  std::mutex settings_mutex_;  // what a motion was checked with stays so until it begins
  std::unique_ptr<Link> link_;
};

}  // namespace c4g_driver
