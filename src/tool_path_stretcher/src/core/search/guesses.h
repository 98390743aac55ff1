// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "alignment/coarse_fit.h"
#include "geometry/points.h"
#include "tool_path_stretcher/prior.h"

namespace tool_path_stretcher {

/// The 24 rotations of a cube.
std::vector<Eigen::Matrix3d> cube_turns();

/// Initial poses: the principal frames in all rotations of a cube (covers flips and nearly equal
/// axes).
std::vector<Similarity> principal_guesses(const CoarsePair& surfaces);

/// Initial poses if those fail: a sweep about the vertical, and an even cover of all rotations.
std::vector<Similarity> even_guesses(const CoarsePair& surfaces);

/// Initial poses around a roughly known one: that pose, the same with the centres of object and
/// reference aligned, and rotations from it by up to its greatest error.
std::vector<Similarity> guesses_about(const Prior& prior, const CoarsePair& surfaces);

/// Initial poses if either surface may show only a part of the other. Three frames that a missing
/// part rotates little (the principal axes, those of the smallest rectangle, and those along which
/// the normals spread) are laid on each other in all rotations of a cube. Each is sized by one axis
/// alone, with ends or centres aligned along each axis, and half or wholly shifted out of each
/// other along one axis.
std::vector<Similarity> overlapping_guesses(const CoarsePair& surfaces);

/// Poses with the reference rotated within itself about its centre: in all rotations of a cube, in
/// small steps about each principal axis, flipped or not, and in an even cover of all rotations,
/// since a part may be symmetric about other axes. A nearly symmetric part is most easily mistaken
/// for one of these poses, so they are tried before a pose is accepted.
std::vector<Similarity> turned_in_itself(const PrincipalFrame& frame, const Similarity& pose);

/// Poses with the reference rotated about an axis about which it is nearly round, so that its
/// holes, teeth or marks coincide with the object's again. Only these tell one rotation from
/// another. Best first; none if the reference is not nearly round, or perfectly round.
std::vector<Similarity> turned_to_marks(const SurfacePair& surfaces, const Similarity& pose);

/// The guess with its scale clamped to the range; the reference's centre stays where it is.
Similarity clamped(const Similarity& guess, const ScaleRange& scales,
                   const Eigen::Vector3d& middle);

}  // namespace tool_path_stretcher
