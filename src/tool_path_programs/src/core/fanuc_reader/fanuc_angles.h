// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>

namespace tool_path_programs {

/// Behind the point, of all numbers that controllers write.
constexpr int kFanucDigits = 3;

/// Position [mm] and angles [degree] as FANUC writes them: X Y Z W P R, where R = Rz(R) Ry(P)
/// Rx(W).
using FanucPose = std::array<double, 6>;

Eigen::Isometry3d pose_of(const FanucPose& numbers);

/// Rounded so that the orientation comes back to within the last digit's half in each direction,
/// also where P is near 90 degrees and the errors of W and R would add up.
/// @param digits behind the point, of W, P and R
FanucPose fanuc_pose(const Eigen::Isometry3d& pose, const std::array<int, 3>& digits);

}  // namespace tool_path_programs
