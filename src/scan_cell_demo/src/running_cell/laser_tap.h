// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <thread>

#include "scan_cell_common/net/udp_socket.h"

namespace scan_cell_demo {

/// A tap on the wire from the trigger's node to the trigger circuit. It forwards each byte and
/// records, by the kernel's time of receipt, when lasers went on and off, even if other nodes are
/// dead.
class LaserTap {
 public:
  /// Listens on one UDP port of 127.0.0.1 and sends to another.
  /// @throw scan_cell_common::ConnectionError if the port is not available
  LaserTap(std::uint16_t listen, std::uint16_t circuit);
  ~LaserTap();
  LaserTap(const LaserTap&) = delete;
  LaserTap& operator=(const LaserTap&) = delete;

  std::uint8_t lasers() const;        //!< mask of the lasers that are on
  std::uint64_t switched_on() const;  //!< number of times lasers went on

  bool wait_until_on(double timeout) const;

  /// How long after an instant on the host's clock the lasers were on; 0 if they were off then.
  /// @return [s]; none: still on after `timeout` [s]
  std::optional<double> on_for(scan_cell_common::Nanoseconds since, double timeout) const;

 private:
  void listen();
  void take(std::uint8_t data, scan_cell_common::Nanoseconds time);

  const scan_cell_common::UdpSocket socket_;
  const scan_cell_common::Endpoint circuit_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::uint8_t lasers_ = 0;
  std::uint64_t switched_on_ = 0;
  scan_cell_common::Nanoseconds off_at_ = 0;  // the last time they went off
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace scan_cell_demo
