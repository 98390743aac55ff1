// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/surface/part_mesh.h"
#include "path_design/trace/trace.h"

namespace part_recipes::path_design {

/// Parallel planes at even distances.
struct Planes {
  Eigen::Vector3d across = Eigen::Vector3d::UnitY();  //!< their normal, unit length
  double first = 0;       //!< [m] of the first, along `across` from the origin
  double spacing = 0;     //!< [m]
  std::size_t count = 0;  //!< of planes
};

/// The lines along which planes cut a mesh, exact in its triangles, for each plane. They run along
/// `across` x normal, so that what is farther along `across` is on their left.
std::vector<std::vector<Trace>> cut(const PartMesh& mesh, const Planes& planes);

/// Joins lines in one plane whose ends are no farther apart than a gap, straight across it.
/// @param lines open ones
/// @param along the direction in which they are followed, unit length
/// @param gap [m]
std::vector<Trace> joined_over_gaps(std::vector<Trace> lines, const Eigen::Vector3d& along,
                                    double gap);

}  // namespace part_recipes::path_design
