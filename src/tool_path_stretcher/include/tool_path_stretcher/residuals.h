// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "tool_path_stretcher/deformation.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// How one point of the object lies to the mapped reference.
struct Residual {
  Eigen::Vector3d pulled_back;  //!< [m] the point in the reference's space
  std::size_t reference;        //!< nearest point of the reference there
  double along_normal;          //!< [m, reference] signed, along the reference's normal
  double beside;                //!< [m, reference] how far beside the nearest point, beyond spacing
};

Residual residual_of(const Surface& reference, const Mapping& mapping,
                     const Eigen::Vector3d& object_point);

std::vector<Residual> residuals_of(const Surface& reference, const Mapping& mapping,
                                   const Points& object_points);

/// How well a mapping explains the object, all in metres of the object.
struct Explanation {
  double rms = 0;                          //!< [m] of the explained points
  double noise = 0;                        //!< [m] robust standard deviation of the residuals
  double inlier_ratio = 0;                 //!< share of object points within the inlier distance
  double overlap = 0;                      //!< share of reference points that the object covers
  std::vector<double> object_distance;     //!< [m] a point of the object
  std::vector<double> reference_distance;  //!< [m] a point of the reference; NaN where not scanned
};

/// @param inlier_distance [m]
Explanation explain(const Surface& reference, const Surface& object, const Mapping& mapping,
                    double inlier_distance);

/// True where `better` explains significantly more points than `other`: the points only one of them
/// explains are counted against each other (McNemar 1947).
bool clearly_better(const Explanation& better, const Explanation& other);

}  // namespace tool_path_stretcher
