// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_cell_common/pose/timed_pose.h"

namespace scan_cell_common {

/// This computer's wall clock, also used for ROS stamps; may be set back.
Nanoseconds host_now();

}  // namespace scan_cell_common
