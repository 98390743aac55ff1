// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <kdl/tree.hpp>
#include <map>
#include <string>

namespace scan_cell_rviz {

/// Where all links of a robot are when its joints have some angles, those beside the chain to the
/// flange, too.
class LinkPoses {
 public:
  /// @param urdf text
  /// @throw scan_cell_common::UnusableInput if it is none
  explicit LinkPoses(const std::string& urdf);

  /// @param base link that the poses are in [m]
  /// @param joints [rad] by name; those not named are at 0
  /// @return by the link's name
  /// @throw scan_cell_common::UnusableInput if the robot has no such base, or no such joint
  std::map<std::string, Eigen::Isometry3d> at(const std::string& base,
                                              const std::map<std::string, double>& joints) const;

 private:
  KDL::Tree tree_;
};

}  // namespace scan_cell_rviz
