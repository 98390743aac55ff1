// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "mapping/deformation.h"

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

/// [m, object] how far the points of two surfaces lie apart where they are one: no pose is known
/// better, however little noise they have.
/// @param scale of the reference
double resolution(const SurfacePair& surfaces, double scale);

/// Distances of the points of one surface from the other.
struct Distances {
  std::vector<double> off;         //!< [m, object]; NaN where the other is not known
  std::vector<double> blur;        //!< [m, object] of that, which sampling and grid may make
  std::vector<std::size_t> patch;  //!< of the surface that a point lies in
};

/// How well a mapping explains the object, all in metres of the object.
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

/// The patches of both surfaces that only one of two explanations explains, by the shares of their
/// points. A point is explained within three times the noise, and within what sampling and grid do
/// to the surfaces there, whatever the noise: an edge is rounded, and no two samples of it alike.
struct Evidence {
  double only_first = 0;
  double only_second = 0;
  double squares = 0;         //!< of the shares
  double patches_first = 0;   //!< those of which only the first explains most points
  double patches_second = 0;  //!< likewise
  double compared = 0;        //!< patches
};
Evidence evidence(const Explanation& first, const Explanation& second);

/// Patches of both surfaces of which most points are not explained.
double unexplained_patches(const Explanation& explanation);

/// Whether there is so little that the mapped reference does not explain that another mapping
/// cannot be clearly better: of few patches most points.
bool explains_all(const Explanation& explanation);

/// True where `better` explains significantly more of the surfaces than `other`: the patches that
/// only one of them explains are counted against each other (McNemar 1947).
bool clearly_better(const Explanation& better, const Explanation& other);

}  // namespace tool_path_stretcher
