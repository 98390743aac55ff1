// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "parts/scan.h"
#include "parts/solids.h"
#include "tool_path_stretcher/stretcher.h"

/// Parts drawn at random: of any size, in any pose, as mesh or cloud, sampled as it happens.
namespace cases {

/// What the drawn object is to the drawn reference.
enum class Draw {
  kSymmetric,        //!< the same part, its own image in another pose; the path is not
  kDistinguishable,  //!< the same part with a hole that only one pose explains
  kMirrored,         //!< the mirror image of a part that no turn makes its own mirror image
  kMirrorSymmetric,  //!< the same part, which has a mirror plane and no other symmetry
};

/// Which shapes are drawn. The second kind was not looked at while the stretcher was made.
enum class Shapes { kKnown, kOthers };

struct DrawnPart {
  std::string name;
  tool_path_stretcher::Reason expected;
  pcl::PolygonMesh reference;
  pcl::PolygonMesh object;
  bool from_mesh;  //!< the reference is given as a mesh, else as a cloud
  std::size_t reference_points;
  std::size_t object_points;
  double noise;  //!< [m] of the clouds
  Eigen::Vector3d leaf;
  Similarity moved;
  ToolPath path;
  unsigned seed;
};

/// @param noise [m] of the clouds' points
DrawnPart draw(Draw what, Shapes shapes, double noise, unsigned seed);

tool_path_stretcher::StretchResult run(const DrawnPart& part);

/// [m] farthest waypoint of an accepted path from where it belongs
double farthest_off(const DrawnPart& part, const ToolPath& adapted);

}  // namespace cases
