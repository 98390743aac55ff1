// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "search/partial_search.h"
#include "verdict/checks.h"

namespace tool_path_stretcher {

/// The pose of a reference that shows only a part of the object, if nothing speaks against it: what
/// both show agrees to within the noise, undeformed. A deformation could make other poses agree.
/// @throw Refusal if another pose agrees as well
std::optional<Similarity> pose_of_partial_reference(const ToolPath& path,
                                                    const SurfacePair& surfaces,
                                                    PartialSearch& search,
                                                    const StretchParameters& parameters);

/// A scan of a part of the object may lie on the wrong end of a reference that is nearly symmetric.
/// Features contradict that end, or a deformation is needed to make it fit. If the reference shows
/// only a part too, another end may even fit as well.
/// @throw Refusal if another pose is contradicted less; or as little, and it needs no deformation
/// or the reference shows only a part
void check_rivals(const ToolPath& path, const SurfacePair& surfaces, const Mapping& best,
                  PartialSearch& search, const StretchParameters& parameters);

}  // namespace tool_path_stretcher
