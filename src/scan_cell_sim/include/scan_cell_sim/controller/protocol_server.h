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

#include "scan_cell_sim/controller/controller_parameters.h"
#include "scan_cell_sim/controller/datagram.h"
#include "scan_cell_sim/controller/drifting_clock.h"
#include "scan_cell_sim/controller/motion_control.h"

namespace scan_cell_sim {

/// How badly the controller measures.
struct MeasurementNoise {
  double position = 0;     //!< [m] standard deviation, each axis
  double orientation = 0;  //!< [rad] standard deviation, about each axis
  unsigned seed = 1;
};

/// A request that the controller took up: once, however often its datagram came.
struct TakenUp {
  std::uint64_t session = 0;
  std::uint64_t seq = 0;
  std::string datagram;
  std::optional<ControllerErrorCode> refused;  //!< why nothing was done; none: it was done
};

/// The controller's side of c4g_protocol.md, without sockets: requests in, answers out.
/// Times are host times. Not safe for use from several threads.
class ProtocolServer {
 public:
  using Nanoseconds = scan_cell_common::Nanoseconds;

  using Witness = std::function<void(const TakenUp&)>;

  /// @param stream_period [s]
  /// @param witness sees every request that is taken up; may be none
  ProtocolServer(MotionControl& motion, const DriftingClock& clock, double stream_period,
                 const MeasurementNoise& noise, const Witness& witness = {});

  /// The answer to a datagram; none where it cannot be told what was asked.
  std::optional<std::string> answer(const Datagram& request, Nanoseconds now);

  /// Ends the session of a client that went silent.
  void watch(Nanoseconds now);

  /// The next datagram of the stream, with the state of this instant; none while the robot stands.
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
  Json state(const MotionState& truth, Nanoseconds now);
  Eigen::Isometry3d measured(const Eigen::Isometry3d& flange);

  MotionControl& motion_;
  const DriftingClock& clock_;
  ControllerParameters parameters_;
  MeasurementNoise noise_;
  std::mt19937 random_;
  Witness witness_;

  std::optional<Peer> client_;
  std::uint64_t session_ = 0;
  std::map<Peer, std::uint64_t> latest_sessions_;  // of each client, open or ended
  std::uint64_t last_seq_ = 0;
  std::string last_answer_;
  Nanoseconds last_heard_ = 0;
  std::uint64_t streamed_ = 0;
  Nanoseconds last_moving_ = 0;
};

}  // namespace scan_cell_sim
