// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "c4g_driver/robot_state.h"
#include "scan_cell_common/pose/wire_pose.h"

namespace c4g_driver {

// Poses, or six joints [deg], as on the wire.
using scan_cell_common::pose_from_wire;
using scan_cell_common::to_wire;
using scan_cell_common::WireSix;

/// @param joints [rad]
WireSix to_wire(const Joints& joints);

/// @return [rad]
Joints joints_from_wire(const WireSix& wire);

}  // namespace c4g_driver
