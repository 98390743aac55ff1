// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "scan_cell_common/pose/timed_pose.h"
#include "scan_cell_sim/laser_line_renderer.h"

namespace scan_cell_sim::gige {

/// A frame as it goes over the wire.
struct Frame {
  std::uint16_t block = 0;  //!< number; 0: none
  scan_cell_common::Nanoseconds time = 0;
  Region region;
  std::vector<std::uint8_t> pixels;  //!< Mono8
};

/// Cuts a frame into the packets of the GigE Vision stream protocol (GVSP 1.2: a leader, the
/// payload, a trailer), for packets of `packet_size` bytes with IP and UDP headers.
class StreamPackets {
 public:
  explicit StreamPackets(std::uint32_t packet_size);

  std::uint32_t count(const Frame& frame) const;

  /// The UDP payload of packet 0 .. count - 1.
  /// @param again sent again on request
  void write(const Frame& frame, std::uint32_t packet, bool again,
             std::vector<std::uint8_t>& bytes) const;

 private:
  std::uint32_t payload_;  // [bytes] of pixels a packet
};

}  // namespace scan_cell_sim::gige
