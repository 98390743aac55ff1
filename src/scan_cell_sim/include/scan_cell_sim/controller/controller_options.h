// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "scan_cell_sim/controller/readiness.h"
#include "scan_cell_sim/controller/wire_faults.h"

namespace scan_cell_sim {

/// Faults between the controller and its client.
struct ControllerFaults {
  WireFaults to_client;    //!< of the controller's datagrams
  WireFaults from_client;  //!< of the client's
  double clock_drift = 0;  //!< the controller's clock runs 1 + drift times as fast as the host's
  unsigned seed = 1;       //!< decides which datagrams are affected

  /// @throw scan_cell_common::InvalidParameter
  void check() const;
};

/// The controller's measurement noise.
struct MeasurementNoise {
  double position = 0;     //!< [m] standard deviation, each axis
  double orientation = 0;  //!< [rad] standard deviation, about each axis
  unsigned seed = 1;       //!< the same seed gives the same noise
};

/// A request that the controller processed: reported once, even if its datagram came repeatedly.
struct TakenUp {
  std::uint64_t session = 0;                   //!< of the client
  std::uint64_t seq = 0;                       //!< of the request
  std::string datagram;                        //!< its text
  std::optional<ControllerErrorCode> refused;  //!< why it was not done; none: it was done
};

/// A simulated controller, as it starts.
struct ControllerOptions {
  std::string address = "127.0.0.1";              //!< IPv4 to listen on
  std::uint16_t port = 5410;                      //!< 0: any free one, see Controller::port()
  double stream_period = 0.004;                   //!< [s] 0.002 .. 0.010
  MeasurementNoise noise;                         //!< of the reported positions
  ControllerMode mode = ControllerMode::kRemote;  //!< at the start, with the drives on
  ControllerFaults faults;                        //!< at the start
  /// Called with every processed request, in the controller's thread; may be empty.
  std::function<void(const TakenUp&)> witness;
};

}  // namespace scan_cell_sim
