// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "c4g_driver/codec.h"
#include "c4g_driver/durations.h"
#include "c4g_driver/goal.h"
#include "c4g_driver/limits.h"
#include "c4g_driver/motion_check.h"
#include "c4g_driver/pose_feed.h"
#include "c4g_driver/sequence_monitor.h"
#include "c4g_driver/udp_socket.h"

namespace c4g_driver {

struct ClientOptions {
  std::string local_address = "0.0.0.0";  //!< IPv4 of this machine's interface to it; 0.0.0.0: any
  std::string address = "127.0.0.1";      //!< IPv4 of the controller
  std::uint16_t port = 5410;
  double link_timeout = 0.5;  //!< [s] no answer, or no fresh pose, for so long is a lost link
  int tries = 10;             //!< how often a request is sent within link_timeout
  double poll_period = 0.1;   //!< [s] between requests for the pose; they keep the session alive
  double reconnect_period =
      0.5;                    //!< [s] between attempts to connect; the first follows a loss at once
  double clock_window = 2.0;  //!< [s] over which the least delay of the wire is sought
  int realtime_priority = 0;  //!< of the receiving thread, SCHED_FIFO; 0: the usual scheduling
  std::shared_ptr<const RobotModel> robot;  //!< required
  RobotLimits limits;
  ArrivalTolerance arrival;
};

/// How the link is.
struct LinkReport {
  bool up = false;
  std::string message;  //!< why it is down, or was the last time
  std::uint64_t losses = 0;
  std::uint64_t attempts = 0;  //!< to connect, since the start or the last loss
  SequenceCounts stream;
  PoseFeed::Counts dropped;
  scan_cell_common::ClockMap::Figures clock;
  Durations late;        //!< what the stream's datagrams were delayed by beyond the wire's least
  Durations round_trip;  //!< of requests that were answered at the first try
  Durations hand_on;     //!< from the kernel's stamp of a datagram until its pose was handed on
  std::uint64_t malformed = 0;
  std::string last_malformed;
  std::uint64_t foreign = 0;
  std::uint64_t overlong = 0;
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
  Client(const ClientOptions& options, const Listener& listener);

  /// Stops the robot if a goal is under way, and closes the session.
  ~Client();

  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// Starts a motion that MotionCheck lets pass; it is sent to the controller once, however often
  /// the packet is.
  void move_to_pose(const Eigen::Isometry3d& flange, double camera_rate);
  void move_to_joints(const std::vector<double>& joints, double camera_rate);

  /// The robot brakes; wait_for_goal() tells when it stands.
  void stop();

  void set_override(double percent);
  void set_linear_speed(double speed);  //!< [m/s]
  void set_drives(bool on);
  void reset_alarms();
  std::string get_parameter(const std::string& name);
  void set_parameter(const std::string& name, const std::string& json);

  /// @throw scan_cell_common::Refused if the robot moves
  MeasuredState static_pose();

  /// Of the controller, for messages: with its address and port.
  const std::string& name() const { return name_; }

  Goal goal() const;

  /// The goal as soon as it ended, or as it is after `timeout` [s].
  Goal wait_for_goal(double timeout) const;

  /// Whether there is a link now, or comes within `timeout` [s].
  bool wait_for_link(double timeout) const;

  std::optional<MeasuredState> latest() const;
  LinkReport link() const;

 private:
  using Clock = std::chrono::steady_clock;

  void start_receiving();
  void receive();
  void handle(const UdpSocket::Received& received);
  void handle(const StreamedState& streamed, scan_cell_common::Nanoseconds arrival);
  void handle(const Acknowledgement& acknowledgement, scan_cell_common::Nanoseconds arrival);
  void take(std::uint64_t session, const RobotState& robot, scan_cell_common::Nanoseconds arrival,
            PoseFeed::Source source);
  bool up() const;
  bool awaited(const Acknowledgement& acknowledgement) const;

  MotionCheck motion_check(bool along_line);
  MotionSettings settings_in_force();
  SpeedLimit speed_limit() const;
  double most_override() const;

  void keep();
  void connect();
  void lose(const std::string& reason);
  void poll();

  /// A motion: its target becomes the goal before anything is sent.
  struct Start {
    Goal::Target target;
    double most_override;  //!< [%] see MotionCheck
  };
  Acknowledgement request(const Request& request, const Start* start = nullptr);
  std::string why_no_answer(const Request& request, std::uint64_t malformed) const;
  std::optional<Acknowledgement> exchange(const std::string& datagram);

  const ClientOptions options_;
  const std::string name_;
  const Listener listener_;
  UdpSocket socket_;

  std::mutex settings_mutex_;  // what a motion was checked with stays so until it begins
  std::mutex request_mutex_;   // one request at a time; taken after settings_mutex_, before mutex_

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  bool up_ = false;
  std::string why_down_ = "no answer yet";
  std::uint64_t losses_ = 0;
  std::uint64_t attempts_ = 0;
  Clock::time_point next_attempt_;  // not before: so a controller is not flooded
  std::uint64_t session_ = 0;
  std::uint64_t seq_ = 0;
  std::optional<Acknowledgement> answer_;
  Goal goal_;
  double most_override_ = 100;  // [%] of the goal
  SequenceMonitor stream_;
  PoseFeed poses_;
  Durations late_;
  Durations round_trip_;
  Durations hand_on_;
  std::uint64_t malformed_ = 0;
  std::string last_malformed_;
  bool ending_ = false;
  std::atomic<bool> deaf_{false};  // after ending_: the receiver hears the last answers

  std::thread receiver_;
  std::thread keeper_;
};

}  // namespace c4g_driver
