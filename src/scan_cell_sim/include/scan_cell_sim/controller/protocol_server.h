// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <random>
#include <string>

#include "scan_cell_sim/controller/controller_parameters.h"
#include "scan_cell_sim/controller/datagram.h"
#include "scan_cell_sim/controller/motion_control.h"

namespace scan_cell_sim {

/// The controller's own clock: microseconds since its start, at a rate that may drift.
class DriftingClock {
 public:
  explicit DriftingClock(scan_cell_common::Nanoseconds start) : host_(start) {}

  std::int64_t microseconds(scan_cell_common::Nanoseconds host) const;
  /// From `host` on it runs 1 + drift times as fast as the host's.
  void set_drift(double drift, scan_cell_common::Nanoseconds host);

 private:
  scan_cell_common::Nanoseconds host_;
  double device_ = 0;  // [ns] at host_
  double drift_ = 0;
};

/// How badly the controller measures.
struct MeasurementNoise {
  double position = 0;     //!< [m] standard deviation, each axis
  double orientation = 0;  //!< [rad] standard deviation, about each axis
  unsigned seed = 1;
};

/// The controller's side of docs/c4g_protocol.md, without sockets: requests in, answers out.
/// Times are host times. Not safe for use from several threads.
class ProtocolServer {
 public:
  using Nanoseconds = scan_cell_common::Nanoseconds;

  ProtocolServer(MotionControl& motion, double stream_period, const MeasurementNoise& noise,
                 Nanoseconds start);

  /// The answer to a datagram; none where it cannot be told what was asked.
  std::optional<std::string> answer(const Datagram& request, Nanoseconds now);

  /// Ends the session of a client that went silent.
  void watch(Nanoseconds now);

  /// The next datagram of the stream, with the state of this instant; none while the robot stands.
  std::optional<std::string> stream(Nanoseconds now);

  const std::optional<Peer>& client() const { return client_; }
  double stream_period() const { return parameters_.stream_period(); }
  DriftingClock& clock() { return clock_; }

 private:
  using Json = nlohmann::json;

  Json reply(const Json& request, const Peer& from, Nanoseconds now);
  void open(const Json& request, const Peer& from, Nanoseconds now);
  Json perform(const Json& request, Nanoseconds now);
  Json state(const MotionState& truth, Nanoseconds now);
  Eigen::Isometry3d measured(const Eigen::Isometry3d& flange);

  MotionControl& motion_;
  ControllerParameters parameters_;
  MeasurementNoise noise_;
  std::mt19937 random_;
  DriftingClock clock_;

  std::optional<Peer> client_;
  std::uint64_t session_ = 0;
  std::uint64_t last_seq_ = 0;
  std::string last_answer_;
  Nanoseconds last_heard_ = 0;
  std::uint64_t streamed_ = 0;
  Nanoseconds last_moving_ = 0;
};

}  // namespace scan_cell_sim
