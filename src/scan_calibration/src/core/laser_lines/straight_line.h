// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace scan_calibration {

/// A point that may lie on the line.
struct LinePoint {
  Eigen::Vector2d place;
  double tolerance;  //!< maximum distance from the line
  double weight;     //!< in the vote
};

struct StraightLine {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
  double deviation = 0;  //!< of its points, robust
  double votes = 0;      //!< weights of its points; 0: there is none

  double distance(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d d = place - point;
    return d.x() * direction.y() - d.y() * direction.x();
  }
};

/// The line with the most votes (RANSAC, Fischler and Bolles 1981, with fixed draws), refined by
/// least squares through the points on it.
StraightLine strongest_line(const std::vector<LinePoint>& points);

}  // namespace scan_calibration
