// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PolygonMesh.h>

#include <functional>
#include <vector>

#include "tool_path_stretcher/tool_path.h"

/// Parts, scans and paths with exact truth, for the benchmark and the tests. No product code reads
/// this.
namespace cases {

using tool_path_stretcher::ToolPath;

struct SurfacePoint {
  Eigen::Vector3d position;  //!< [m]
  Eigen::Vector3d normal;    //!< unit length, out of the part
};

/// A piece of a surface, sampled with u and v in 0 .. 1.
struct Facet {
  double area;  //!< [m^2]
  std::function<SurfacePoint(double u, double v)> at;
};

/// A part: everything a scanner may see of it, and the tool path on it.
struct Part {
  double size = 0;  //!< [m] half the diagonal
  std::vector<Facet> facets;
  ToolPath path;  //!< z along the normal, x along the path
};

constexpr std::size_t kWaypoints = 400;

/// A photo frame of 200 x 150 mm with a moulding 25 mm wide and 20 mm high; the path runs along its
/// crest. A rosette of the given height breaks the symmetry; 0: none.
Part photo_frame(double rosette);

/// The photo frame with another moulding: lower, with the crest elsewhere.
Part other_frame();

/// A box of 180 x 120 x 60 mm. With the pocket, a corner is 6 mm deeper, and the path runs over the
/// lid and down a side; without, the box is symmetric.
Part box(bool pocket);

/// The symmetric box with an equally symmetric path: a loop on the lid.
Part box_with_loop();

/// A doubly curved panel of 300 x 200 mm, open, without walls.
Part curved_panel();

/// A panel of the same outline with other curvatures.
Part other_panel();

/// A straight moulding of 240 x 50 mm. Only its ends show the position along it.
Part straight_moulding();

/// A cup: a body of revolution of 120 mm. The path is a line down one side.
Part cup();

/// An angle bracket with legs of 120 and 80 mm, 60 mm wide and 8 mm thick; the path runs over the
/// inner side of one leg and up the other.
Part bracket();

/// A turned shaft of 160 mm with shoulders. The path is a helix on its middle. Only the keyway, 40
/// x 8 x 4 mm in its far end, shows the rotation about the axis.
Part shaft(bool keyway);

/// The shaft without keyway, with a symmetric path: once around.
Part shaft_with_ring();

/// A plate of 240 x 160 mm with four ribs and a boss; the path runs between two ribs and over none.
/// @param moved_rib [m] shift of the third rib to the side: another variant of the part
Part ribbed_plate(double moved_rib = 0);

/// A quarter bend of 80 mm radius of a pipe of 50 mm, with a flange; the path winds along the
/// outside of the bend.
Part elbow();

/// The part with a part of its path: the waypoints between two shares of their number.
Part with_path_between(Part part, double from, double to);

/// The part with the longest piece of its path between two shares of its extent along x.
Part with_path_within(Part part, double from, double to);

/// A part from a mesh with its own path.
Part part_of_mesh(const pcl::PolygonMesh& mesh, const ToolPath& path);

}  // namespace cases
