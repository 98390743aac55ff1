// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scanner_views/parts/mesh_builder.h"
#include "scanner_views/scanner/line_scanner.h"

namespace scanner_views {

/// The directions from which a part is scanned.
enum class Viewing {
  kAboveOneLaser,
  kAboveBothLasers,
  kLeaningOneLaser,  //!< by 20 degrees to one side
  kTwoSides,         //!< two sweeps leaning by 30 degrees, both lasers
};

struct Looking {
  Viewing viewing;
  double around = 0;  //!< [m] of the surroundings scanned with the part
};

/// [m] diagonal of its bounding box
double extent_of(const Mesh& mesh);

/// How much coarser a large part is scanned. Up to 0.35 m, lines are about 1.2 mm apart.
double coarseness_of(const Mesh& part);

/// The scan of the meshes, with random spacings and heading.
/// @param meshes [m] the part first, z up
ScanPoints scan(const std::vector<Mesh>& meshes, const Looking& looking, Draws& draws);

/// Adds stray points.
/// @param share relative to the existing points
void scatter(double share, const Mesh& around, Draws& draws, ScanPoints& points);

}  // namespace scanner_views
