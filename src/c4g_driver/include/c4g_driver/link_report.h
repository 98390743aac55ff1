// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "c4g_driver/durations.h"
#include "scan_cell_common/clock/clock_map.h"

namespace c4g_driver {

/// What the numbers of a stream tell about the wire.
struct SequenceCounts {
  std::uint64_t received = 0;   //!< datagrams
  std::uint64_t lost = 0;       //!< numbers that never came
  std::uint64_t repeated = 0;   //!< numbers that came again
  std::uint64_t reordered = 0;  //!< came after a later one
};

/// Poses that were not handed on.
struct DroppedPoses {
  std::uint64_t overtaken = 0;  //!< measured no later than one that came before
  std::uint64_t backward = 0;   //!< their instant was not after that of the one before
};

/// Datagrams that the protocol does not allow.
struct Malformed {
  std::uint64_t count = 0;  //!< since the start
  std::string last;         //!< what was wrong with the last one
};

/// How the link is.
struct LinkReport {
  bool up = false;                            //!< the controller answers
  std::string message = "no answer yet";      //!< why it is down, or was the last time
  std::uint64_t losses = 0;                   //!< of the link, since the start
  std::uint64_t attempts = 0;                 //!< to connect, since the start or the last loss
  SequenceCounts stream;                      //!< of the streamed positions
  DroppedPoses dropped;                       //!< positions that were not handed on
  scan_cell_common::ClockMap::Figures clock;  //!< how the controller's clock maps to the host's
  Durations late;        //!< what the stream's datagrams were delayed by beyond the wire's least
  Durations round_trip;  //!< of requests that were answered at the first try
  Durations hand_on;     //!< from the kernel's stamp of a datagram until its pose was handed on
  Malformed malformed;   //!< from the controller
  std::uint64_t foreign = 0;   //!< datagrams from somebody else
  std::uint64_t overlong = 0;  //!< datagrams that were too long
};

}  // namespace c4g_driver
