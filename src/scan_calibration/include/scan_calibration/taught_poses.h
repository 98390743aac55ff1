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
  std::vector<int> lines;                //!< line of the file, per pose: its name in reports
};

/// Reads a CSV file: a header that gives the units, then a pose per line. Empty lines and lines
/// that begin with # are ignored.
///
///     x,y,z                              points [m]
///     x,y,z,qx,qy,qz,qw                  poses [m, unit quaternion]
///     x_mm,y_mm,z_mm,a_deg,e_deg,r_deg   poses as C4G shows them [mm, degrees, Z-Y-Z]
///
/// @throw scan_cell_common::FileError if the file is missing or unreadable
/// @throw scan_cell_common::UnusableInput naming the invalid line, also if the numbers contradict
/// the header's units or a pose is repeated
TaughtPoses load_taught_poses(const std::string& path);

/// The same from the text of such a file. @param name name of the text in error messages
TaughtPoses parse_taught_poses(const std::string& text, const std::string& name);

/// Appends a pose to such a file of poses in metres, and creates the file if it is missing. The
/// file is whole at any moment, and its old lines are not changed.
/// @param flange pose of tool0 in base_link [m]
/// @return number of poses now in the file
/// @throw scan_cell_common::FileError if it cannot be read or written
/// @throw scan_cell_common::UnusableInput if the file is of another kind, or already has the pose
std::size_t append_taught_pose(const std::string& path, const Eigen::Isometry3d& flange);

}  // namespace scan_calibration
