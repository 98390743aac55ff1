// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/socket.h>

#include <optional>

#include "scan_cell_common/timed_pose.h"

namespace scan_cell_common {

/// This computer's wall clock, by which ROS stamps, too; may be set back.
Nanoseconds host_now();

/// When the kernel received a datagram, on the clock of host_now().
/// @param message as recvmsg() filled it, from a socket with SO_TIMESTAMPNS
/// @return none where the message does not say
std::optional<Nanoseconds> receipt_time(const msghdr& message);

}  // namespace scan_cell_common
