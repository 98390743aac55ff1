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
  double share = 1;          //!< scanned share of the part's extent along x, from one end
  bool far_end = false;      //!< from the end where x is greatest
  double density_ratio = 1;  //!< between the two ends along y
  double hole = 0;           //!< [m] radius of holes in the scan, a third of the size apart
  double outliers = 0;       //!< share of the points, anywhere around
  bool floor = false;        //!< adds a strip of floor beside the part, with a tenth of the points
  unsigned seed = 1;
};

/// A scan of the deformed part, moved by the similarity.
Points scan(const Part& part, const Deformation& deformation, const Similarity& similarity,
            const Scan& how);

/// The true path on the deformed and moved part.
ToolPath truth(const ToolPath& path, const Deformation& deformation, const Similarity& similarity);

/// Errors of an adapted path, RMS over the counted waypoints.
struct PathError {
  double normal = 0;       //!< [m]
  double tangential = 0;   //!< [m]
  double orientation = 0;  //!< [rad]
  double worst = 0;        //!< [m] largest distance
};
/// @param counted_along whether a waypoint's error along the surface counts; empty: all count
PathError error_of(const ToolPath& path, const ToolPath& truth,
                   const std::vector<bool>& counted_along);

Eigen::Matrix3d random_rotation(unsigned seed);

}  // namespace cases
