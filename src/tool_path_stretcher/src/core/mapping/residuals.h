// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "mapping/deformation.h"

namespace tool_path_stretcher {

/// The position of one object point relative to the mapped reference.
struct Residual {
  Eigen::Vector3d pulled_back;  //!< [m] the point in the reference's space
  std::size_t reference;        //!< nearest point of the reference there
  double along_normal;          //!< [m, reference] signed, along the reference's normal
  double beside;  //!< [m, reference] lateral distance from the nearest point, beyond the spacing
};

Residual residual_of(const Surface& reference, const Mapping& mapping,
                     const Eigen::Vector3d& object_point);

std::vector<Residual> residuals_of(const Surface& reference, const Mapping& mapping,
                                   const Points& object_points);

/// [m, object] distance between the points of two surfaces that coincide. No pose is known better,
/// however little noise they have.
/// @param scale of the reference
double resolution(const SurfacePair& surfaces, double scale);

/// Distances of the points of one surface from the other.
struct Distances {
  std::vector<double> off;         //!< [m, object]; NaN where the other surface is unknown
  std::vector<double> blur;        //!< [m, object] part of it that sampling and grid may cause
  std::vector<std::size_t> patch;  //!< patch of the surface that each point lies in
};

/// How well a mapping explains the object; all lengths in metres of the object.
struct Explanation {
  double rms = 0;           //!< [m] of the explained points
  double noise = 0;         //!< [m] robust standard deviation of the residuals, or the resolution
  double inlier_ratio = 0;  //!< share of object points within the inlier distance
  double overlap = 0;       //!< share of reference points that the object covers
  Distances object;
  Distances reference;
};

/// @param inlier_distance [m]
Explanation explain(const SurfacePair& surfaces, const Mapping& mapping, double inlier_distance);

/// A mapping that was fitted to the object, and how well it explains it.
struct Fitted {
  Mapping mapping;
  Explanation explanation;
};

Fitted fitted(const SurfacePair& surfaces, const Mapping& mapping, double inlier_distance);

/// The patches of both surfaces that only one of two explanations explains, counted by the shares
/// of their points. A point is explained if its distance is within three times the noise, or within
/// the local error of sampling and grid, whatever the noise: an edge is rounded, and no two samples
/// of it are alike.
struct Evidence {
  double only_first = 0;
  double only_second = 0;
  double squares = 0;         //!< sum of the squared shares
  double patches_first = 0;   //!< patches of which only the first explains most points
  double patches_second = 0;  //!< likewise
  double compared = 0;        //!< patches
};
Evidence evidence(const Explanation& first, const Explanation& second);

/// Number of patches of both surfaces with most points unexplained.
double unexplained_patches(const Explanation& explanation);

/// Whether so few patches have most points unexplained that no other mapping can be clearly better.
bool explains_all(const Explanation& explanation);

/// Whether `better` explains significantly more of the surfaces than `other`: compares the counts
/// of patches that only one of them explains (McNemar 1947).
bool clearly_better(const Explanation& better, const Explanation& other);

}  // namespace tool_path_stretcher
