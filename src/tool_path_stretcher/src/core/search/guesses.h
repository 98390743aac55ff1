// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "alignment/coarse_fit.h"
#include "geometry/points.h"
#include "tool_path_stretcher/prior.h"

namespace tool_path_stretcher {

/// The 24 turns of a cube.
std::vector<Eigen::Matrix3d> cube_turns();

/// Poses to start from: the principal frames in all the turns of a cube (flips and near equal axes
/// included).
std::vector<Similarity> principal_guesses(const CoarsePair& surfaces);

/// Poses to start from where those fail: a sweep about the vertical, and an even cover of all
/// rotations.
std::vector<Similarity> even_guesses(const CoarsePair& surfaces);

/// Poses to start from where one is known roughly: that one, the same with the object's middle on
/// the reference's, and those turned from it by up to the angle it may be off.
std::vector<Similarity> guesses_about(const Prior& prior, const CoarsePair& surfaces);

/// Poses to start from where either surface may show only a part of what the other shows: three
/// frames that a missing part turns little (the principal axes, those of the smallest rectangle,
/// and those along which the normals spread) laid on each other in all the turns of a cube, each
/// sized by one axis alone, with ends or middles together along each axis, and half way or wholly
/// out of each other along one of them.
std::vector<Similarity> overlapping_guesses(const CoarsePair& surfaces);

/// A pose with the reference turned within itself about its middle: as a cube is, in small steps
/// about each principal axis, turned over or not, and evenly in all ways, since a part may have
/// symmetries about axes that are not principal ones. A nearly symmetric part is most easily taken
/// for one of these poses, so they are looked at before one is believed.
std::vector<Similarity> turned_in_itself(const PrincipalFrame& frame, const Similarity& pose);

/// A pose with the reference turned about the axes that it is nearly round about, to where its
/// holes, teeth or marks, which are all that tells one turn from another, come to lie on the
/// object's again. Best first; none where it is not nearly round, or round altogether.
std::vector<Similarity> turned_to_marks(const SurfacePair& surfaces, const Similarity& pose);

/// The guess with its scale in the range; the middle of the reference stays where it is.
Similarity clamped(const Similarity& guess, const ScaleRange& scales,
                   const Eigen::Vector3d& middle);

}  // namespace tool_path_stretcher
