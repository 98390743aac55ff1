// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "quality/uncertainty.h"

namespace scan_calibration {

/// A scanned point, as a pixel sees it in the light of a laser.
struct ScanPlace {
  std::size_t laser = 0;
  double depth = 0;
  Eigen::Vector2d pixel;
};

/// Points at the near, middle and far depth at which each laser's line was seen (5, 50 and 95 % of
/// its points), spread along the line across the image.
std::vector<ScanPlace> scan_places(const JointEstimate& estimate, const BoardSurface& surface);

/// Derivative of the triangulated point in tool0 [m] by the shared unknowns: three rows.
Eigen::MatrixXd triangulation_derivative(const JointEstimate& estimate, const Knowledge& knowledge,
                                         const ScanPlace& place);

std::vector<PointUncertainty> point_uncertainties(const JointEstimate& estimate,
                                                  const Knowledge& knowledge,
                                                  const std::vector<ScanPlace>& places,
                                                  const std::vector<std::string>& lasers);

}  // namespace scan_calibration
