// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "scan_cell_common/net/endpoint.h"
#include "scan_cell_common/pose/timed_pose.h"

namespace scan_cell_common {

/// What was received with a datagram.
struct StampedDatagram {
  std::size_t size = 0;  //!< [bytes] written
  bool cut = false;      //!< it was longer than the room for it
  Endpoint from;         //!< the sender, on a socket of AF_INET
  /// when the kernel received it, on the clock of host_now(); none if the socket lacks
  /// SO_TIMESTAMPNS
  std::optional<Nanoseconds> receipt;
};

/// Takes the next datagram of a socket without waiting or allocating.
/// @param data room for `size` bytes
/// @return none if nothing waits or the socket has failed
std::optional<StampedDatagram> receive_stamped(int socket, void* data, std::size_t size);

}  // namespace scan_cell_common
