// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace tool_path_programs {

/// Values of axes X Y Z A B C: [mm] and [degrees]; NaN where not known.
using GcodeAxes = Eigen::Matrix<double, 6, 1>;

/// The axes of a dialect, and how they give the tool's orientation.
class GcodeDialect {
 public:
  /// @param name xyzabc, xyzac, xyzbc, xyz; empty: the first
  /// @throw scan_cell_common::InvalidParameter if there is no such dialect
  explicit GcodeDialect(const std::string& name);

  const std::string& name() const { return name_; }
  const std::vector<Eigen::Index>& axes() const { return axes_; }  //!< of X Y Z A B C
  bool has(Eigen::Index axis) const;

  /// Whether the axes give the turn of the tool about its own axis.
  bool says_orientations() const { return name_ == "xyzabc"; }

  /// The tip's pose [m], its z axis into the part.
  ///
  /// xyzabc: as LinuxCNC's kinematics of robots take it, roll A, pitch B, yaw C about fixed axes:
  /// R = Rz(C) Ry(B) Rx(A). xyzac and xyzbc: the spindle, from the tip up, has the direction
  /// Rz(C) Rx(A) z or Rz(C) Ry(B) z in the part, signs as of ISO 841 for tools that turn (a table
  /// that turns the part goes the other way). xyz: the spindle stands along z.
  Eigen::Isometry3d pose(const GcodeAxes& axes) const;

  /// The axes for a pose. Of all solutions the one nearest to `before`: rotary axes do not jump by
  /// whole turns.
  GcodeAxes axes(const Eigen::Isometry3d& pose, const GcodeAxes& before) const;

 private:
  std::vector<Eigen::Vector3d> solutions(const Eigen::Matrix3d& rotation,
                                         const GcodeAxes& before) const;

  std::string name_;
  std::vector<Eigen::Index> axes_;
};

}  // namespace tool_path_programs
