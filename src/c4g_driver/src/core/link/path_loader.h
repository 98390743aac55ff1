// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "c4g_driver/tool_motion.h"
#include "link/link.h"

namespace c4g_driver {

/// Loads a path into the controller. Nothing moves.
/// @param path its number
/// @param go_on called before each piece; empty: always go on
/// @return the request that follows the path, once the controller has confirmed all of it
/// @throw as Link::request(); scan_cell_common::UnusableInput if the protocol cannot represent the
/// path; scan_cell_common::Refused if go_on returns false; scan_cell_common::ProtocolError if the
/// controller has received another path than was sent
FollowPath load_path(Link& link, const ToolMotion& motion, std::uint64_t path, std::uint64_t from,
                     const std::function<bool()>& go_on);

}  // namespace c4g_driver
