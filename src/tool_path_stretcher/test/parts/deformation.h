// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>

namespace cases {

/// The position [m] of a point of the part after the deformation.
using Deformation = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

Deformation none();

/// One after the other.
Deformation both(Deformation first, Deformation second);

/// Bends around a cylinder along y, so that `width` sags by `rise` [m]; lengths along z = 0 are
/// kept.
Deformation bend(double rise, double width);

/// Twists about x by `angle` [rad] in total over `width` [m].
Deformation twist(double angle, double width);

/// A Gaussian hill of `rise` [m] along z, or a dent if `rise` is below 0.
Deformation bulge(double rise, double radius, const Eigen::Vector2d& at);

/// A Gaussian hill around a place in space, in any direction; `rise` is its top [m].
Deformation bulge_at(const Eigen::Vector3d& at, const Eigen::Vector3d& rise, double radius);

/// Stretches within x and y by up to `most` [m], unevenly.
Deformation swelling(double most, double width);

/// Files down to a plane: moves everything beyond the plane onto it.
Deformation filed(const Eigen::Vector3d& normal, double distance);

/// The deformed frame of a point and its normal. The first axis stays along the path.
Eigen::Isometry3d deformed(const Deformation& deformation, const Eigen::Isometry3d& pose);

}  // namespace cases
