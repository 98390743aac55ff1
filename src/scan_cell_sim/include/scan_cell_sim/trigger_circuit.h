// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "scan_cell_common/net/udp_socket.h"

namespace scan_cell_sim {

/// Emulates the circuit at the parallel port: each write to the port's data register is a UDP
/// datagram of one byte. Bit 0 is the camera's pulse, bits 1 and 2 are laser_0 and
/// laser_1; the circuit keeps its state until the next write. It runs in its own thread while
/// it has power, which it has from the start. All methods are safe to call from any thread.
class TriggerCircuit {
 public:
  /// A rising edge of the camera's line.
  struct Pulse {
    scan_cell_common::Nanoseconds time = 0;  //!< host time at which the byte came
    std::uint8_t lasers = 0;                 //!< bit mask of the lasers that are on: 1, 2
  };

  /// State of the circuit's lines.
  struct State {
    std::uint8_t lasers = 0;        //!< mask of those that are on
    bool pulse_line = false;        //!< level of the camera's line
    std::uint64_t pulses = 0;       //!< so far
    std::uint64_t writes = 0;       //!< datagrams of one byte so far
    std::uint64_t refused = 0;      //!< datagrams that were not one byte
    double longest_on[2] = {0, 0};  //!< [s] of each laser, the present one included
  };

  using Observer = std::function<void(const Pulse&)>;  //!< called with each pulse

  /// @param port 0: any free one, see port()
  /// @throw scan_cell_common::InvalidParameter if the address is not an IPv4 address
  /// @throw scan_cell_common::ConnectionError if the port cannot be opened
  TriggerCircuit(const std::string& address, std::uint16_t port);
  ~TriggerCircuit();

  TriggerCircuit(const TriggerCircuit&) = delete;
  TriggerCircuit& operator=(const TriggerCircuit&) = delete;

  std::uint16_t port() const { return endpoint_.port; }  //!< it listens on

  /// Sets the observer of the pulses, called in the circuit's thread; none if empty. When this
  /// returns, the previous observer is no longer called.
  void observe(const Observer& observer);
  State state() const;  //!< of this moment

  /// For what share of an interval of host time each laser was on, 0 .. 1. Everything sent before
  /// this call counts; later datagrams are assumed to change nothing. The observer may be called
  /// with pulses in the caller's thread.
  std::array<double, 2> lit(scan_cell_common::Nanoseconds begin, scan_cell_common::Nanoseconds end);

  /// Without power nobody listens on the port, and all lines are low.
  /// @throw scan_cell_common::ConnectionError if another program took the port meanwhile
  void set_power(bool on);

 private:
  /// From `time` on, these lasers are on.
  struct Change {
    scan_cell_common::Nanoseconds time = 0;
    std::uint8_t lasers = 0;
  };

  void listen();
  void take_all();
  void write(std::uint8_t data, scan_cell_common::Nanoseconds time);
  bool set_lines(std::uint8_t data, scan_cell_common::Nanoseconds time);

  std::mutex power_mutex_;   // of the socket and the thread
  std::mutex socket_mutex_;  // held while datagrams are taken, one after the other
  std::optional<scan_cell_common::UdpSocket> socket_;
  const scan_cell_common::Endpoint endpoint_;
  std::mutex observer_mutex_;  // held while the observer is called
  Observer observer_;
  mutable std::mutex mutex_;  // what follows
  State state_;
  scan_cell_common::Nanoseconds on_since_[2] = {0, 0};
  std::deque<Change> changes_;  // of the last seconds; before them the lasers were off
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace scan_cell_sim
