// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parts/deformation.h"
#include "parts/part.h"
#include "tool_path_stretcher/similarity.h"

namespace cases {

using tool_path_stretcher::Points;
using tool_path_stretcher::Similarity;

/// How a part is scanned.
struct Scan {
  std::size_t points = 20000;
  double noise = 0.0001;     //!< [m] of each coordinate
  bool from_above = false;   //!< surfaces that face away from z are not seen
  double share = 1;          //!< of the part's extent along x that is scanned, from one end
  bool far_end = false;      //!< that end is the one where x is greatest
  double density_ratio = 1;  //!< of one end along y to the other
  double hole = 0;           //!< [m] radius of holes in the scan, a third of the size apart
  double outliers = 0;       //!< share of the points, anywhere around
  bool floor = false;        //!< a strip of floor beside the part, with a tenth of the points
  unsigned seed = 1;
};

/// A scan of the deformed part, moved by the similarity.
Points scan(const Part& part, const Deformation& deformation, const Similarity& similarity,
            const Scan& how);

/// Where the path comes to lie on the deformed and moved part.
ToolPath truth(const ToolPath& path, const Deformation& deformation, const Similarity& similarity);

/// Errors of an adapted path, RMS over the waypoints counted.
struct PathError {
  double normal = 0;       //!< [m]
  double tangential = 0;   //!< [m]
  double orientation = 0;  //!< [rad]
  double worst = 0;        //!< [m] of the distance
};
/// @param counted_along whether a waypoint's error along the surface is counted; empty: all are
PathError error_of(const ToolPath& path, const ToolPath& truth,
                   const std::vector<bool>& counted_along);

Eigen::Matrix3d random_rotation(unsigned seed);

}  // namespace cases
