// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "loopback_circuit.h"
#include "scan_cell_common/pose/timed_pose.h"

namespace laser_trigger {

/// A trigger circuit on its own UDP port that records when the kernel received each rising edge of
/// the camera's line. It reads only from time to time, to avoid disturbing the measurement.
class EdgeListener {
 public:
  EdgeListener() = default;
  ~EdgeListener();
  EdgeListener(const EdgeListener&) = delete;
  EdgeListener& operator=(const EdgeListener&) = delete;

  PortAddress address() const { return circuit_.address(); }

  /// Listens from now on, in its own thread.
  void start();

  /// Ends listening.
  /// @return host time of each rising edge [ns]
  std::vector<scan_cell_common::Nanoseconds> stop();

 private:
  void listen();
  bool take();

  LoopbackCircuit circuit_{"127.0.0.1", 0};
  std::uint8_t data_ = 0;
  std::vector<scan_cell_common::Nanoseconds> edges_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace laser_trigger
