// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parts/solids.h"
#include "scanner_views/parts/mesh_builder.h"

namespace scanner_views {

using cases::Loop;

/// A flat face of a milled or cast part, with the wall from the face it stands on: up to a boss or
/// a rib, down into a pocket or through the part.
struct Terrace {
  Loop outline;                     //!< [m] of its foot, relative to the part's middle
  double height = 0;                //!< [m] of the face above the part's underside
  std::vector<Terrace> on_it = {};  //!< apart from each other and from its rim
  double taper = 1;                 //!< size of the face relative to its foot
  double chamfer = 0;               //!< [m] height of the chamfer around it
  bool through = false;             //!< a hole through the part: it has no face
};

/// The closed surface of a part that stands on z = 0.
Mesh solid_of(const Terrace& base);

Loop shifted(Loop loop, const Eigen::Vector2d& by);
Loop turned(Loop loop, double angle);

Terrace hole(const Eigen::Vector2d& at, double radius);

}  // namespace scanner_views
