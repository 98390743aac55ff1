// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/nearest_grid.h"
#include "search/alignment.h"

namespace tool_path_stretcher {

/// A surface thinned for the search over all poses.
struct CoarseSurface {
  PrincipalFrame frame;
  Points queries;                      //!< few points, to look up in the other's
  std::shared_ptr<NearestGrid> found;  //!< more points, to be found
  Points normals;                      //!< of those, unit length
};

CoarseSurface coarsen(const Surface& surface);

/// The 24 turns of a cube.
std::vector<Eigen::Matrix3d> cube_turns();

/// An even cover of all rotations: the super-Fibonacci spiral (Alexa 2022).
std::vector<Eigen::Matrix3d> even_rotations(int count);

/// Poses to start from: the principal frames in all the turns of a cube (flips and near equal axes
/// included).
std::vector<Similarity> principal_guesses(const PrincipalFrame& reference,
                                          const PrincipalFrame& object);

/// Poses to start from where those fail: a sweep about the vertical, and an even cover of all
/// rotations.
std::vector<Similarity> even_guesses(const PrincipalFrame& reference, const PrincipalFrame& object);

/// Point-to-point ICP in both directions, the farthest pairs left out.
Candidate improve_coarsely(const CoarseSurface& reference, const CoarseSurface& object,
                           Similarity guess, const ScaleRange& scales, int iterations);

/// The guess with its scale in the range; the middle of the reference stays where it is.
Similarity clamped(const Similarity& guess, const ScaleRange& scales,
                   const Eigen::Vector3d& middle);

/// Poses to start from where one is known roughly: that one, the same with the object's middle on
/// the reference's, and those turned from it by up to the angle it may be off.
std::vector<Similarity> guesses_about(const Prior& prior, const PrincipalFrame& reference,
                                      const PrincipalFrame& object);

}  // namespace tool_path_stretcher
