// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mapping/residuals.h"
#include "tool_path_stretcher/stretch_parameters.h"

namespace tool_path_stretcher {

/// MIRRORED_PART: the mirror image of the reference explains the object, clearly better than the
/// reference does: almost everything that only one of the two explains speaks for it. Both explain
/// a part with a mirror plane equally well. If the reference was deformed, its undeformed shape is
/// compared with the mirror image too, because a small difference between the hands can be bent
/// away.
/// @param best of the reference
/// @throw Refusal
void check_handedness(const SurfacePair& surfaces, const Fitted& best,
                      const StretchParameters& parameters);

}  // namespace tool_path_stretcher
