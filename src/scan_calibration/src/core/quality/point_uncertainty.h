// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "quality/uncertainty.h"

namespace scan_calibration {

/// A point of the scan: what a pixel and a laser show.
struct ScanPlace {
  std::size_t laser = 0;
  double depth = 0;
  Eigen::Vector2d pixel;
};

/// Points at near, middle and far depth of where each laser's line was seen (5, 50 and 95 % of its
/// points), spread along the line from one end of the image to the other.
std::vector<ScanPlace> scan_places(const JointEstimate& estimate, const BoardSurface& surface);

/// Derivative of the triangulated point in tool0 [m] by the shared unknowns: three rows.
Eigen::MatrixXd triangulation_derivative(const JointEstimate& estimate, const Knowledge& knowledge,
                                         const ScanPlace& place);

std::vector<PointUncertainty> point_uncertainties(const JointEstimate& estimate,
                                                  const Knowledge& knowledge,
                                                  const std::vector<ScanPlace>& places,
                                                  const std::vector<std::string>& lasers);

}  // namespace scan_calibration
