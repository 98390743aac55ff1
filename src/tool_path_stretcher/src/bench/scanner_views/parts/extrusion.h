// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parts/solids.h"
#include "scanner_views/parts/mesh_builder.h"

namespace scanner_views {

/// A profile cut to length, lying along y.
struct Extrusion {
  cases::Loop section;     //!< [m] (x, z), without crossings
  double length = 0;       //!< [m] at the section's origin
  double slant_front = 0;  //!< offset of the front face backwards per metre of x
  double slant_back = 0;   //!< the same for the back
};

/// Its closed surface, standing on z = 0 and centred in x and y.
Mesh solid_of(const Extrusion& extrusion);

/// A ring from closed lines with equally many points, one after the other and back to the first.
/// Each line is a section. The inside is left of the lines' direction, seen from one line to the
/// next.
Mesh ring_of(const std::vector<Points>& lines);

/// A surface over u and v in 0 .. 1, open at its rim; its outside is d/du x d/dv.
template <class At>
Mesh sheet_of(const At& at, int columns, int rows) {
  MeshBuilder builder;
  const auto corner = [&](int column, int row) {
    return at(static_cast<double>(column) / columns, static_cast<double>(row) / rows);
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      builder.quad(corner(column, row), corner(column + 1, row), corner(column + 1, row + 1),
                   corner(column, row + 1));
    }
  }
  return builder.take();
}

/// The mesh moved to stand on z = 0, centred in x and y.
Mesh standing(Mesh mesh);

}  // namespace scanner_views
