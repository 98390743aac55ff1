// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_cell_sim/part.h"

namespace scan_cell_sim {

inline Eigen::Isometry3d pose(double x, double y, double z, double turn_about_z = 0) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() << x, y, z;
  result.linear() = Eigen::AngleAxisd(turn_about_z, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return result;
}

/// A frame with every kind of deformation.
inline Part bent_frame() {
  Part part;
  part.name = "frame";
  part.shape = FrameShape{};
  part.scale = 1.08;
  part.pose = pose(0.01, -0.02, 0.003, 0.4);
  part.deformation.add(Bend{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), 0.6});
  part.deformation.add(
      Bulge{Eigen::Vector3d(0.05, 0.06, 0), Eigen::Vector3d::UnitZ(), 0.025, 0.003});
  part.deformation.add(FiledEdge{Eigen::Vector3d(-0.05, -0.065, 0.02),
                                 Eigen::Vector3d(0, -0.065, 0.02), -Eigen::Vector3d::UnitZ(), 0.005,
                                 0.0015});
  return part;
}

inline Part box(const std::string& name, const Eigen::Vector3d& size,
                const Eigen::Isometry3d& place) {
  Part part;
  part.name = name;
  part.shape = BoxShape{size};
  part.pose = place;
  return part;
}

}  // namespace scan_cell_sim
