// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>

namespace scan_cell_common {

/// Process id of a ROS node on this machine, as the node reports it; none if it does not answer.
/// For tests and trials that kill nodes.
std::optional<pid_t> process_of(const std::string& node);

/// Whether some process publishes a topic. A subscriber does not notice that a publisher was
/// killed: roscpp keeps it and tries again and again to reach it.
/// @return none if the ROS master does not answer
std::optional<bool> is_published(const std::string& topic);

/// Whether a server accepts TCP connections there, within a second.
bool listens(const std::string& host, std::uint32_t port);

}  // namespace scan_cell_common
