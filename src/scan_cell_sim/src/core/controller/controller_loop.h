// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "controller/protocol_server.h"
#include "controller/wire/faulty_wire.h"
#include "scan_cell_common/net/udp_socket.h"
#include "scan_cell_sim/controller/controller_options.h"

namespace scan_cell_sim {

/// The controller's thread: receives requests on its socket and streams states, both through wires
/// with faults. All public methods are safe to call from any thread.
class ControllerLoop {
 public:
  /// @throw as Controller
  ControllerLoop(const ControllerOptions& options, const Joints& start);
  ~ControllerLoop();

  ControllerLoop(const ControllerLoop&) = delete;
  ControllerLoop& operator=(const ControllerLoop&) = delete;

  std::uint16_t port() const { return socket_.local().port; }
  MotionControl& motion() { return motion_; }
  const DriftingClock& clock() const { return clock_; }

  void set_faults(const ControllerFaults& faults);
  void restart(double dark);

 private:
  using Nanoseconds = scan_cell_common::Nanoseconds;

  std::unique_ptr<ProtocolServer> make_server();
  void serve();
  void adopt(const ControllerFaults& faults);
  bool is_on(Nanoseconds now);
  void receive(const WireFaults& faults);
  void answer_received(const WireFaults& faults);
  /// @param heard host time up to which everything was received
  void stream(const WireFaults& faults, Nanoseconds heard);
  void send_due();
  ControllerFaults faults() const;

  const ControllerOptions options_;
  const scan_cell_common::UdpSocket socket_;
  MotionControl motion_;
  DriftingClock clock_;
  std::unique_ptr<ProtocolServer> server_;
  FaultyWire incoming_;
  FaultyWire outgoing_;
  ControllerFaults adopted_;

  mutable std::mutex mutex_;  // of what follows
  ControllerFaults faults_;
  Nanoseconds faults_since_ = 0;
  std::optional<Nanoseconds> dark_until_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace scan_cell_sim
