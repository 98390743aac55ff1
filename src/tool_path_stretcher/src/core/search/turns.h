// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tool_path_stretcher/points.h"
#include "tool_path_stretcher/similarity.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// A pose with the reference turned within itself about its middle: as a cube is, in small steps
/// about each principal axis, turned over or not, and evenly in all ways, since a part may have
/// symmetries about axes that its principal ones do not show. These are the poses that a nearly
/// symmetric part is most easily taken for; they must have been looked at before one is believed.
std::vector<Similarity> turned_in_itself(const PrincipalFrame& frame, const Similarity& pose);

/// A pose with the reference turned about the axes that it is nearly round about, to where its
/// holes, teeth or marks, which are all that tells one turn from another, come to lie on the
/// object's again. Best first; none where it is not nearly round, or round altogether.
std::vector<Similarity> turned_to_marks(const Surface& reference, const Surface& object,
                                        const Similarity& pose);

}  // namespace tool_path_stretcher
