// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_stretcher/residuals.h"
#include "tool_path_stretcher/stretch_parameters.h"

namespace tool_path_stretcher {

/// The surface seen in a mirror: x is -x.
Surface mirrored(const Surface& surface);

/// MIRRORED_PART: the mirror image of the reference explains the object, and clearly better than
/// the reference does: all but a little of what only one of the two explains speaks for it. A part
/// that has a mirror plane is explained by both alike. Where the reference was deformed, it is also
/// held against its mirror image undeformed: a small difference of the hands can be bent away.
/// @param best mapping of the reference
/// @param explanation by that
/// @throw Refusal
void check_handedness(const Surface& reference, const Surface& object, const Mapping& best,
                      const Explanation& explanation, const StretchParameters& parameters);

}  // namespace tool_path_stretcher
