// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace tool_path_programs {

/// Orientations as Universal Robots write them: a vector along the axis of rotation whose length is
/// the angle [rad].

/// Decimals of metres and radians in a script.
constexpr int kScriptDigits = 7;

/// With an angle from 0 to pi.
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation);

/// The vector of the rotation nearest to `old`, within one whole turn: programs also hold vectors
/// longer than pi.
Eigen::Vector3d rotation_vector_near(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& old);

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& vector);

}  // namespace tool_path_programs
