// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scanner_views/parts/mesh_builder.h"
#include "scanner_views/scanner/line_scanner.h"

namespace scanner_views {

/// From where a part is scanned.
enum class Viewing {
  kAboveOneLaser,
  kAboveBothLasers,
  kLeaningOneLaser,  //!< by 20 degrees to one side
  kTwoSides,         //!< two sweeps that lean by 30 degrees, both lasers
};

struct Looking {
  Viewing viewing;
  double around = 0;  //!< [m] of what surrounds the part that is scanned as well
};

/// [m] the farthest two points of its box are apart
double extent_of(const Mesh& mesh);

/// How much coarser a large part is scanned: lines are about 1.2 mm apart up to 0.35 m.
double coarseness_of(const Mesh& part);

/// What a scanner sees; its spacings and heading are drawn.
/// @param meshes [m] the part first, z up
ScanPoints scan(const std::vector<Mesh>& meshes, const Looking& looking, Draws& draws);

/// Adds points that are nobody's.
/// @param share of the points that are there
void scatter(double share, const Mesh& around, Draws& draws, ScanPoints& points);

}  // namespace scanner_views
