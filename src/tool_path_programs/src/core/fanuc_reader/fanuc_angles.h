// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>

namespace tool_path_programs {

/// Decimals of all numbers that controllers write.
constexpr int kFanucDigits = 3;

/// Position [mm] and angles [degree] as FANUC writes them: X Y Z W P R, where R = Rz(R) Ry(P)
/// Rx(W).
using FanucPose = std::array<double, 6>;

Eigen::Isometry3d pose_of(const FanucPose& numbers);

/// Rounds a pose so that the orientation is read back within half of the last digit in each
/// direction, also near P = 90 degrees, where the errors of W and R would add up.
/// @param digits decimals of W, P and R
FanucPose fanuc_pose(const Eigen::Isometry3d& pose, const std::array<int, 3>& digits);

}  // namespace tool_path_programs
