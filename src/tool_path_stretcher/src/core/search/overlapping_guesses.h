// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "search/hypotheses.h"

namespace tool_path_stretcher {

/// Poses to start from where either surface may show only a part of what the other shows: three
/// frames that a missing part turns little (the principal axes, those of the smallest rectangle,
/// and those along which the normals spread) laid on each other in all the turns of a cube, each
/// sized by one axis alone, with ends or middles together along each axis, and half way or wholly
/// out of each other along one of them.
std::vector<Similarity> overlapping_guesses(const CoarseSurface& reference,
                                            const CoarseSurface& object);

}  // namespace tool_path_stretcher
