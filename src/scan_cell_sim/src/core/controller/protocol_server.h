// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <random>
#include <string>

#include "controller/controller_parameters.h"
#include "controller/loaded_path.h"
#include "controller/motion/motion_control.h"
#include "controller/wire/datagram.h"
#include "controller/wire/drifting_clock.h"
#include "scan_cell_sim/controller/controller_options.h"

namespace scan_cell_sim {

/// The controller's side of c4g_protocol.md, without sockets: requests in, answers out.
/// Times are host times. Not safe for use from several threads.
class ProtocolServer {
 public:
  using Nanoseconds = scan_cell_common::Nanoseconds;
  using Peer = scan_cell_common::Endpoint;

  /// @param options stream period, noise and witness are used
  ProtocolServer(MotionControl& motion, const DriftingClock& clock,
                 const ControllerOptions& options);

  /// The answer to a datagram; none if the request is unreadable.
  std::optional<std::string> answer(const Datagram& request, Nanoseconds now);

  /// Ends the session of a client that went silent.
  void watch(Nanoseconds now);

  /// The next datagram of the stream, with the state of this instant; none while the robot stands
  /// still.
  std::optional<std::string> stream(Nanoseconds now);

  const std::optional<Peer>& client() const { return client_; }
  double stream_period() const { return parameters_.stream_period(); }

 private:
  using Json = nlohmann::json;

  Json reply(const Json& request, const Datagram& datagram, Nanoseconds now);
  void open(const Json& request, std::uint64_t session, std::uint64_t seq, const Peer& from,
            Nanoseconds now);
  Json take_up(const Json& request, const std::string& datagram, Nanoseconds now);
  Json perform(const Json& request, Nanoseconds now);
  std::optional<Json> load(const std::string& command, const Json& request);
  bool begin_motion(const std::string& command, const Json& request, Nanoseconds now);
  Json state(const MotionState& truth, Nanoseconds now);
  Eigen::Isometry3d measured(const Eigen::Isometry3d& flange);

  MotionControl& motion_;
  const DriftingClock& clock_;
  ControllerParameters parameters_;
  MeasurementNoise noise_;
  std::mt19937 random_;
  const std::function<void(const TakenUp&)> witness_;

  std::optional<Peer> client_;
  std::uint64_t session_ = 0;
  std::map<Peer, std::uint64_t> latest_sessions_;  // of each client, open or ended
  std::uint64_t last_seq_ = 0;
  std::string last_answer_;
  Nanoseconds last_heard_ = 0;
  std::uint64_t streamed_ = 0;
  LoadedPath path_;
  Nanoseconds follow_watch_ = 0;  // of the client's silence, while it is followed
  Nanoseconds last_moving_ = 0;
};

}  // namespace scan_cell_sim
