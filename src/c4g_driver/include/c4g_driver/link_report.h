// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "scan_cell_common/clock/clock_map.h"
#include "scan_cell_common/clock/durations.h"

namespace c4g_driver {

/// What the sequence numbers of a stream tell about the network.
struct SequenceCounts {
  std::uint64_t received = 0;   //!< datagrams
  std::uint64_t lost = 0;       //!< numbers that never arrived
  std::uint64_t repeated = 0;   //!< numbers that arrived again
  std::uint64_t reordered = 0;  //!< numbers that arrived after a later one
};

/// Poses that were not delivered.
struct DroppedPoses {
  std::uint64_t overtaken = 0;  //!< measured no later than a pose that arrived before
  std::uint64_t backward = 0;   //!< host time not after that of the pose before
};

/// Datagrams that the protocol does not allow.
struct Malformed {
  std::uint64_t count = 0;  //!< since the start
  std::string last;         //!< what was wrong with the last one
};

/// State of the link.
struct LinkReport {
  bool up = false;                            //!< the controller answers
  std::string message = "no answer yet";      //!< why it is down, or why it was down last
  std::uint64_t losses = 0;                   //!< of the link, since the start
  std::uint64_t attempts = 0;                 //!< to connect, since the start or the last loss
  SequenceCounts stream;                      //!< of the streamed positions
  DroppedPoses dropped;                       //!< positions that were not delivered
  scan_cell_common::ClockMap::Figures clock;  //!< how the controller's clock maps to the host's
  /// Delay of the stream's datagrams beyond the network's least delay.
  scan_cell_common::Durations late;
  scan_cell_common::Durations round_trip;  //!< of requests answered at the first try
  /// From the kernel's stamp of a datagram to the delivery of its pose.
  scan_cell_common::Durations hand_on;
  Malformed malformed;         //!< datagrams from the controller
  std::uint64_t foreign = 0;   //!< datagrams from other senders
  std::uint64_t overlong = 0;  //!< datagrams that were too long
};

}  // namespace c4g_driver
