// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "scan_cell_sim/deformation.h"

namespace scan_cell_sim {

/// Triangles over points [m]; seen from outside they turn counter-clockwise.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;                //!< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  //!< indices of vertices
};

/// A bulging sheet in a frame's opening.
struct Sheet {
  double height = 0.003;  //!< [m] of its border over the frame's underside
  double bulge = 0;       //!< [m] of its middle over its border
};

/// Photo frame: a rectangular ring of moulding (moulding.h), centred on its own origin, standing on
/// z = 0. A hanger outside its +x side near the +y corner makes it differ from itself after a half
/// turn.
struct FrameShape {
  Eigen::Vector2d size = {0.200, 0.150};  //!< [m] outside
  std::optional<Sheet> sheet;             //!< in its opening, if any
};

/// Box, centred in x and y on its own origin, standing on z = 0.
struct BoxShape {
  Eigen::Vector3d size = {0.10, 0.06, 0.04};  //!< [m]
};

/// Pipe that turns by a right angle, closed at its ends, lying on z = 0. Its axis comes along x,
/// bends and leaves along y; the two straight axes would meet at x = y = 0.
struct ElbowShape {
  double pipe_radius = 0.02;  //!< [m] outside
  double bend_radius = 0.06;  //!< [m] of the axis
  double leg = 0.06;          //!< [m] of each straight end
};

using Shape = std::variant<FrameShape, BoxShape, ElbowShape>;  //!< of a part

/// Position of a frame's hanger: lower and upper corner of its foot and its height [m].
struct Hanger {
  Eigen::Vector3d least;  //!< lower corner
  Eigen::Vector3d most;   //!< upper corner
};
Hanger hanger_of(const FrameShape& frame);  //!< of an undeformed frame

/// Surface of the undeformed shape, fine enough that no flat triangle is more than `tolerance` [m]
/// off the surface, even after `deformation` is applied to its vertices.
Mesh tessellate(const Shape& shape, const Deformation& deformation, double tolerance);

}  // namespace scan_cell_sim
