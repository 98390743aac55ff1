// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/trace/trace.h"

namespace part_recipes::path_design {

/// An open trace with two corners wherever it crosses a sharp edge: where the planes of both sides
/// meet, on the shortest way across.
/// @param crease_angle [rad] between the normals of a sharp edge
Trace with_bends(const Trace& trace, double crease_angle);

}  // namespace part_recipes::path_design
