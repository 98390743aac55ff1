// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <kdl/tree.hpp>
#include <map>
#include <string>

namespace scan_cell_rviz {

/// Poses of all links of a robot for given joint angles, also of links outside the chain to the
/// flange.
class LinkPoses {
 public:
  /// @param urdf text
  /// @throw scan_cell_common::UnusableInput if the text is no URDF
  explicit LinkPoses(const std::string& urdf);

  /// @param base link that the poses are in [m]
  /// @param joints [rad] by name; those not named are at 0
  /// @return poses by link name
  /// @throw scan_cell_common::UnusableInput if the robot has no such base or joint
  std::map<std::string, Eigen::Isometry3d> at(const std::string& base,
                                              const std::map<std::string, double>& joints) const;

 private:
  KDL::Tree tree_;
};

}  // namespace scan_cell_rviz
