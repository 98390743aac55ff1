// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/viewport_mouse_event.h>

#include "edit/picking.h"
#include "view/cloud_frame.h"

namespace scan_cell_rviz {

/// The ray under the mouse, a few pixels wide.
/// @param frame of the result
Ray ray_under(const rviz::ViewportMouseEvent& event, const CloudFrame& frame);

}  // namespace scan_cell_rviz
