// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "c4g_driver/client.h"
#include "link/pose_feed.h"
#include "link/receiver.h"
#include "link/sequence_monitor.h"
#include "wire/codec.h"
#include "wire/peer_socket.h"

namespace c4g_driver {

constexpr const char* kCheckLink = "check the cable, the address and the controller's program";

/// The session with the controller: connects by itself, reconnects after a loss, keeps the session
/// alive, carries one request at a time, and tracks the goal. A lost link ends the goal here, under
/// the same lock as everything else, so that no part of it can be sent again. All methods are
/// thread-safe.
class Link {
 public:
  /// @param options checked
  /// @throw scan_cell_common::InvalidParameter as PeerSocket and Receiver
  Link(const ClientOptions& options, Client::Listener listener);

  /// Stops the robot if a goal is in progress, and closes the session.
  ~Link();

  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  /// A motion: its target becomes the goal before anything is sent.
  struct Start {
    Goal::Target target;
    double max_override;  //!< [%] see MotionCheck
  };

  /// @param start given if the request starts a motion
  /// @param sent receives the datagram, if not null
  /// @throw as Client's requests
  Acknowledgement request(const Request& request, const Start* start = nullptr,
                          std::string* sent = nullptr);

  const std::string& name() const { return name_; }
  Goal goal() const;
  Goal wait_for_goal(double timeout) const;
  double max_override() const;  //!< [%] of the goal; 100 if none is in progress
  bool up() const;
  bool wait_until_up(double timeout) const;
  std::optional<MeasuredState> latest() const;
  LinkReport report() const;

 private:
  using Clock = std::chrono::steady_clock;
  using Nanoseconds = scan_cell_common::Nanoseconds;

  void keep();
  double period() const;
  double patience() const;
  bool follows() const;
  void connect();
  void poll();
  void lose(const std::string& reason);

  std::string next_datagram(const Request& request, const Start* start);
  std::optional<Acknowledgement> exchange(const std::string& datagram);
  std::string why_no_answer(const Request& request, std::uint64_t malformed) const;

  void handle(const StreamedState& streamed, Nanoseconds arrival);
  void handle(const Acknowledgement& acknowledgement, Nanoseconds arrival);
  bool awaited(const Acknowledgement& acknowledgement) const;
  void take(std::uint64_t session, const RobotState& robot, Nanoseconds arrival,
            PoseFeed::Source source);

  const ClientOptions options_;
  const std::string name_;
  const Client::Listener listener_;
  PeerSocket socket_;

  std::mutex request_mutex_;  // one request at a time; taken before mutex_
  mutable std::mutex mutex_;  // guards all that follows
  mutable std::condition_variable changed_;
  LinkReport report_;               // without what the members count themselves
  Clock::time_point next_attempt_;  // earliest time, so that the controller is not flooded
  std::uint64_t session_ = 0;
  std::uint64_t seq_ = 0;
  std::optional<Acknowledgement> answer_;
  Goal goal_;
  double max_override_ = 100;  // [%] of the goal
  double watch_ = 0;           // [s] above 0: the goal is a tool path; 0: another motion
  SequenceMonitor stream_;
  PoseFeed poses_;
  bool ending_ = false;

  Receiver receiver_;  // ends last, to receive the answers to the last requests
  std::thread keeper_;
};

}  // namespace c4g_driver
