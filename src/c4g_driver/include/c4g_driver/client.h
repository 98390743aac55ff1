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

/// Where the controller is, and the limits and tolerances of the client's motions.
struct ClientOptions {
  std::string local_address = "0.0.0.0";  //!< IPv4 of the local interface to it; 0.0.0.0: any
  std::string address = "127.0.0.1";      //!< IPv4 of the controller
  std::uint16_t port = 5410;              //!< UDP port of the controller
  double link_timeout = 0.5;              //!< [s] without answer or fresh pose: the link is lost
  int tries = 10;                         //!< how often a request is sent within link_timeout
  double poll_period = 0.1;    //!< [s] between pose requests, which keep the session alive
  double follow_watch = 0.08;  //!< [s] without a request after which the controller ends a tool
                               //!< path; requests are sent ten times as often meanwhile
  double reconnect_period =
      0.5;  //!< [s] between attempts to connect; after a loss the first is immediate
  double clock_window = 2.0;  //!< [s] over which the least network delay is taken
  int realtime_priority = 0;  //!< of the receiving thread, SCHED_FIFO; 0: normal scheduling
  std::shared_ptr<const RobotModel> robot;  //!< required
  RobotLimits limits;                       //!< every motion is checked against them
  ArrivalTolerance arrival;                 //!< what counts as arrived
  ToolCheckParameters tool_check;           //!< how a tool path is checked
};

/// The driver's side of c4g_protocol.md. Connects by itself, reconnects after a loss, keeps the
/// session alive, and delivers every measured pose once, in time order.
///
/// A lost link drops the goal: no part of it is sent again, and the new session makes the
/// controller discard requests still in transit. All methods are thread-safe. Requests throw
/// - scan_cell_common::Refused if the limits or the controller refuse; then nothing was done,
/// - scan_cell_common::ConnectionError if there is no link, or it was lost during the request.
class Client {
 public:
  /// Called from the client's own thread; must not make requests of the client.
  using Listener = std::function<void(const MeasuredState&)>;

  /// @throw scan_cell_common::InvalidParameter if an option is invalid or not permitted
  Client(const ClientOptions& options, Listener listener);

  /// Stops the robot if a goal is in progress, and closes the session.
  ~Client();

  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// Starts a motion if the robot can carry it out. The controller begins it once, however often
  /// the packet is repeated.
  void move(const Motion& motion);
  /// @throw as move()
  void move_to_pose(const Eigen::Isometry3d& flange, double camera_rate);
  /// Moves along the circle through `via`, which is passed with its orientation. @throw as move()
  void move_along_arc(const Eigen::Isometry3d& via, const Eigen::Isometry3d& flange,
                      double camera_rate);
  /// Moves all axes together to six joints [rad]. @throw as move()
  void move_to_joints(const std::vector<double>& joints, double camera_rate);

  /// Starts to move in one direction, as far as the robot can, up to half a metre or a quarter
  /// turn. Call stop() to end it earlier. @throw as move(), if the robot cannot move that way at
  /// all
  void jog(const Jog& jog);

  /// Follows a tool path if the robot can: checks it, loads it into the controller, and begins it
  /// when the controller has confirmed all of it. The tip must stand at the waypoint to begin with.
  /// @param from waypoint to begin with, counted from 0; 0: the whole path
  /// @param go_on called while the path is loaded; if it returns false, nothing moves
  /// @throw as move(); scan_cell_common::UnusableInput if the path is invalid
  void follow(const ToolMotion& motion, std::size_t from = 0,
              const std::function<bool()>& go_on = nullptr);

  /// Checks whether the robot could follow a path; nothing moves.
  /// @param from as of follow()
  /// @param joints six [rad], where the robot starts; empty: its present joints
  /// @return waypoints are counted from `from`
  ToolCheck check(const ToolMotion& motion, std::size_t from, const std::vector<double>& joints);

  /// Checks whether the robot could carry out motions one after the other; nothing moves. If the
  /// robot starts where it stands and a motion is in progress or still braking, waits up to 0.5 s
  /// for its end.
  /// @param linear the robot moves to poses along lines, whatever is set on the controller
  /// @param joints six [rad], where the first motion starts; empty: where the robot stands
  PlanCheck check(const std::vector<PlannedMotion>& plan, bool linear,
                  const std::vector<double>& joints);

  /// Brakes the robot; wait_for_goal() waits until it stands.
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

  /// Name of the controller for messages, with its address and port.
  const std::string& name() const;

  Goal goal() const;  //!< the latest one

  /// Returns the goal as soon as it has ended, or its state after `timeout` [s].
  Goal wait_for_goal(double timeout) const;

  /// Whether there is a link now or within `timeout` [s].
  bool wait_for_link(double timeout) const;

  std::optional<MeasuredState> latest() const;  //!< none before the first answer
  LinkReport link() const;                      //!< at this moment

 private:
  /// Sends the motion that `choose` selects, checked from where the robot stands.
  template <class Choose>
  void begin(bool in_joints, const Choose& choose);
  RobotState current() const;
  RobotState standing() const;
  MotionSettings settings_in_force();
  SpeedLimit speed_limit() const;
  ToolCheck check_path(const ToolMotion& motion, std::size_t from, const RobotState& state);

  const ClientOptions options_;
  std::uint64_t paths_ = 0;    // loaded; under settings_mutex_
  std::mutex settings_mutex_;  // settings stay as checked until the motion begins
  std::unique_ptr<Link> link_;
};

}  // namespace c4g_driver
