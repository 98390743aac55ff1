// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// The part of a surface that is visible from at least one of the directions: it faces the viewer
/// and nothing is in front of it. Faces parallel to a direction, and up to 10 degrees beyond, are
/// included: a viewer above the middle sees the walls beside it. An open surface has two faces. The
/// result may be empty, without tree and rim.
/// @param directions unit length, towards the viewers, in the surface's frame
Surface seeable_part(const Surface& surface, const Points& directions);

}  // namespace tool_path_stretcher
