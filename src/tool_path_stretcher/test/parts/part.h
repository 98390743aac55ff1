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

/// A piece of a surface, drawn from with u and v in 0 .. 1.
struct Facet {
  double area;  //!< [m^2]
  std::function<SurfacePoint(double u, double v)> at;
};

/// A part as all that a scanner may see of it, and the tool path on it.
struct Part {
  double size = 0;  //!< [m] half the diagonal
  std::vector<Facet> facets;
  ToolPath path;  //!< z along the normal, x along the path
};

constexpr std::size_t kWaypoints = 400;

/// A photo frame of 200 x 150 mm, its moulding 25 mm wide and 20 mm high, the path along the crest
/// of the moulding. A rosette of the given height breaks its symmetry; 0: none.
Part photo_frame(double rosette);

/// The photo frame with another moulding: lower, and its crest elsewhere.
Part other_frame();

/// A box of 180 x 120 x 60 mm. With the pocket, a corner is 6 mm deeper, and the path runs over the
/// lid and down a side; without, the box is symmetric.
Part box(bool pocket);

/// The symmetric box with a path that is its own image under the symmetry: a loop on the lid.
Part box_with_loop();

/// A doubly curved panel of 300 x 200 mm, open, without walls.
Part curved_panel();

/// A panel of the same outline with other curvatures.
Part other_panel();

/// A straight moulding of 240 x 50 mm, whose surface tells nothing of the position along it but at
/// its ends.
Part straight_moulding();

/// A cup: a figure of revolution of 120 mm, its path a line down one side.
Part cup();

/// An angle bracket with legs of 120 and 80 mm, 60 mm wide and 8 mm thick; the path runs over the
/// inner side of one leg and up the other.
Part bracket();

/// A turned shaft of 160 mm with shoulders, the path a helix on its middle. Only the keyway, 40 x 8
/// x 4 mm in its far end, tells how far it is turned.
Part shaft(bool keyway);

/// The shaft without keyway, with a path that is its own image: once around.
Part shaft_with_ring();

/// A plate of 240 x 160 mm with four ribs and a boss; the path runs between two ribs and over none.
/// @param moved_rib [m] of the third rib to the side: another variant of the part
Part ribbed_plate(double moved_rib = 0);

/// A quarter of a pipe of 50 mm round a bend of 80 mm, with a flange; the path winds along the
/// outside of the bend.
Part elbow();

/// The part with some of its path: the waypoints between two shares of their count.
Part with_path_between(Part part, double from, double to);

/// The part with the longest piece of its path that lies between two shares of its extent along x.
Part with_path_within(Part part, double from, double to);

/// A part from a mesh with its own path.
Part part_of_mesh(const pcl::PolygonMesh& mesh, const ToolPath& path);

}  // namespace cases
