// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mapping/deformation.h"
#include "tool_path_stretcher/tool_path.h"

namespace tool_path_stretcher {

/// Whether both mappings lay the path along the same line on the object, in either direction, with
/// the same process values and tool orientations, as for a symmetric path on a symmetric part.
/// @param tolerance [m]
bool same_path(const ToolPath& path, const Mapping& one, const Mapping& other, double tolerance);

/// The mapping with the reference slid along itself, in the two directions that the surfaces resist
/// least (Gelfand 2003), and then fitted to the object again. A body of revolution, or a part that
/// is too straight, stays where it was slid to.
std::vector<Mapping> slid_along_itself(const SurfacePair& surfaces, const Mapping& mapping,
                                       const ScalePrior& scale);

/// The same for a bent part, bent anew from each place. A graph fitted beside the right place has
/// bent the reference to the surface there, which keeps it from sliding on.
std::vector<Mapping> slid_and_bent(const SurfacePair& surfaces, const Mapping& mapping,
                                   const ScalePrior& scale, int finest_level);

}  // namespace tool_path_stretcher
