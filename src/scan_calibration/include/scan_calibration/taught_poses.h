// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace scan_calibration {

/// Poses or points that were taught.
struct TaughtPoses {
  bool has_orientation = false;          //!< false: points only, rotations are identity
  std::vector<Eigen::Isometry3d> poses;  //!< [m] in base_link, in the file's order
};

/// Reads a CSV file: a header `x,y,z` or `x,y,z,qx,qy,qz,qw`, then a pose a line [m, unit
/// quaternion]. Empty lines and lines that begin with # are left out.
/// @throw scan_cell_common::FileError if the file is missing or unreadable
/// @throw scan_cell_common::UnusableInput naming the line that makes no sense
TaughtPoses load_taught_poses(const std::string& path);

}  // namespace scan_calibration
