// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>

#include "camera/control_server.h"
#include "camera/stream_packets.h"

namespace scan_cell_sim::gige {

/// Packets that do not reach the client; the same ones for the same seed.
struct PacketFaults {
  double lost = 0;       //!< share that is lost even if sent again
  double lost_once = 0;  //!< share that is lost the first time
  std::uint64_t seed = 1;
};

/// Sends frames packet by packet, no faster than a wire could. Keeps the last ones, to send their
/// packets again. To be used from one thread.
class FrameSender {
 public:
  /// @param rate [bytes/s] of the wire
  /// @throw as camera_socket()
  FrameSender(const std::string& address, double rate);

  bool busy() const { return next_packet_.has_value() || !requests_.empty(); }

  /// Memory for the next frame's pixels, taken from a frame that is no longer kept.
  std::vector<std::uint8_t> spare_pixels();

  /// Begins to send a frame; the previous one must be finished.
  void begin(Frame frame, std::uint32_t packet_size, const PacketFaults& faults);
  void request(const ControlServer::ResendRequest& request);
  void abort();

  /// Sends as much as the wire can take now.
  void send(scan_cell_common::Nanoseconds now, const Endpoint& peer);

  /// When the wire is free for more.
  scan_cell_common::Nanoseconds next() const { return next_; }

 private:
  std::size_t send_packet(const Frame& frame, std::uint32_t packet, bool again,
                          const Endpoint& peer);
  std::size_t send_requested(const Endpoint& peer);
  std::size_t send_next(const Endpoint& peer);

  const scan_cell_common::UdpSocket socket_;
  double rate_;
  StreamPackets packets_{0};
  PacketFaults faults_;
  std::deque<Frame> frames_;  // the last is under way
  std::optional<std::uint32_t> next_packet_;
  std::deque<ControlServer::ResendRequest> requests_;
  scan_cell_common::Nanoseconds next_ = 0;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace scan_cell_sim::gige
