// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// The part of a surface that can be seen from at least one of the directions: what faces it, and
/// nothing stands before. Faces along a direction, and up to 10 degrees beyond, are in it: a viewer
/// above the middle sees the walls beside it. A surface that is not closed has two faces. None may
/// be left; that has no tree and no rim.
/// @param directions unit length, towards the viewers, in the surface's frame
Surface seeable_part(const Surface& surface, const Points& directions);

}  // namespace tool_path_stretcher
