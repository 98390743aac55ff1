// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scanner_views/draws.h"
#include "scanner_views/parts/mesh_builder.h"

namespace scanner_views {

/// What may stand around a scanned part.
struct Surroundings {
  bool floor = false;
  bool clamps = false;     //!< two, each with a finger on the part's rim
  bool neighbour = false;  //!< another such part beside it
};

/// Their surfaces.
/// @param part the part in its pose, z up
/// @param alike the part undeformed, for the neighbour
std::vector<Mesh> meshes_of(const Surroundings& surroundings, const Mesh& part, const Mesh& alike,
                            Draws& draws);

}  // namespace scanner_views
