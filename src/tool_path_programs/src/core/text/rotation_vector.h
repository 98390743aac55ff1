// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace tool_path_programs {

/// Orientations as Universal Robots write them: the axis of one turn, as long as its angle [rad].

/// Behind the point, of metres and radians in a script.
constexpr int kScriptDigits = 7;

/// Of an angle from 0 to pi.
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation);

/// Of all vectors of that rotation up to one whole turn, the nearest to `old`: programs hold
/// vectors beyond pi, too.
Eigen::Vector3d rotation_vector_near(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& old);

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& vector);

}  // namespace tool_path_programs
