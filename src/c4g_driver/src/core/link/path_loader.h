// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "c4g_driver/tool_motion.h"
#include "link/link.h"

namespace c4g_driver {

/// Brings a path to the controller. Nothing moves.
/// @param path its number
/// @param go_on asked before each piece; empty: always
/// @return the request that follows it, once the controller has confirmed all of it
/// @throw as Link::request(); scan_cell_common::UnusableInput if the protocol has no place for it;
/// scan_cell_common::Refused if it is not to go on; scan_cell_common::ProtocolError if the
/// controller has another path than was sent
FollowPath load_path(Link& link, const ToolMotion& motion, std::uint64_t path, std::uint64_t from,
                     const std::function<bool()>& go_on);

}  // namespace c4g_driver
