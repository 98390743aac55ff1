// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "parts/scan.h"
#include "parts/solids.h"
#include "tool_path_stretcher/stretcher.h"

/// Random parts: of any size, in any pose, as mesh or cloud, with any sampling.
namespace cases {

/// The relation of the random object to the random reference.
enum class Draw {
  kSymmetric,        //!< the same symmetric part; the path is not symmetric
  kDistinguishable,  //!< the same part, with a hole that only one pose explains
  kMirrored,         //!< the mirror image of a chiral part
  kMirrorSymmetric,  //!< the same part, with a mirror plane and no other symmetry
};

/// The kind of shapes. The second kind was not used during the stretcher's development.
enum class Shapes { kKnown, kOthers };

struct DrawnPart {
  std::string name;
  tool_path_stretcher::Reason expected;
  pcl::PolygonMesh reference;
  pcl::PolygonMesh object;
  bool from_mesh;  //!< the reference is a mesh, otherwise a cloud
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

/// [m] largest distance of a waypoint of an accepted path from the truth
double farthest_off(const DrawnPart& part, const ToolPath& adapted);

}  // namespace cases
