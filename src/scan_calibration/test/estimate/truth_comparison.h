// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "estimate/synthetic_session.h"
#include "scan_calibration/calibration.h"

namespace synthetic {

/// The rotation vector of the truth that is nearest to the stated one.
inline Eigen::Vector3d vector_near(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& stated) {
  const Eigen::AngleAxisd turn(rotation);
  const Eigen::Vector3d one = turn.angle() * turn.axis();
  const Eigen::Vector3d two = (turn.angle() - 2 * M_PI) * turn.axis();
  return (one - stated).norm() < (two - stated).norm() ? one : two;
}

/// The true value of each parameter, in the order of the calibration's.
inline std::vector<double> true_parameters(const Cell& cell,
                                           const scan_calibration::Calibration& calibration) {
  std::vector<double> truth;
  const auto add_pose = [&](const Eigen::Isometry3d& pose) {
    for (int i = 0; i < 3; ++i)
      truth.push_back(pose.translation()[i]);
    const auto& stated = calibration.parameters;
    const Eigen::Vector3d vector(stated[truth.size()].value, stated[truth.size() + 1].value,
                                 stated[truth.size() + 2].value);
    const Eigen::Vector3d near = vector_near(pose.linear(), vector);
    truth.insert(truth.end(), near.begin(), near.end());
  };
  const scan_cell_common::CameraIntrinsics& camera = cell.scanner.camera;
  truth = {camera.fx, camera.fy, camera.cx, camera.cy};
  truth.insert(truth.end(), camera.distortion.begin(), camera.distortion.end());
  add_pose(cell.scanner.flange_to_camera);
  for (std::size_t i = 0; i < cell.scanner.lasers.size(); ++i) {
    const scan_cell_common::LaserPlane& laser = cell.scanner.laser(i);
    truth.insert(truth.end(), laser.normal.begin(), laser.normal.end());
    truth.push_back(laser.distance);
  }
  add_pose(cell.base_to_board);
  return truth;
}

/// The error of the worst parameter, in its stated deviations, and its name.
inline std::pair<double, std::string> worst_miss(const Cell& cell,
                                                 const scan_calibration::Calibration& calibration) {
  const std::vector<double> truth = true_parameters(cell, calibration);
  std::pair<double, std::string> worst{0, ""};
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const scan_calibration::EstimatedParameter& parameter = calibration.parameters[i];
    const double miss = std::abs(parameter.value - truth[i]) / parameter.deviation;
    if (miss > worst.first) worst = {miss, parameter.name};
  }
  return worst;
}

}  // namespace synthetic
