// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

namespace tool_path_stretcher {

/// The shortest text that comes back as the same number.
std::string to_text(double number);

/// @param xyzw quaternion as stored in files; lengths of 1 +- 0.001 are normalised
/// @param where file and line, for the error
/// @throw scan_cell_common::UnusableInput if it is not of unit length
Eigen::Matrix3d rotation_from(const Eigen::Vector4d& xyzw, const std::string& where);

}  // namespace tool_path_stretcher
