// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ceres/cost_function.h>

#include "geometry/board_view.h"
#include "scan_calibration/calibration.h"

namespace scan_calibration {

/// What all residuals of one estimate refer to. It must outlive the residuals.
struct ResidualContext {
  ScannerState reference;  //!< poses that the motions start from
  BoardSurface surface;
  NoiseLevels noise;
};

/// Parameters, in this order: camera [9], motion of flange_to_camera [6], of base_to_board [6],
/// bend [3], correction of the flange [6].
/// Residuals: two per corner, divided by the noise, times the root of its weight.
class CornerResiduals : public ceres::CostFunction {
 public:
  CornerResiduals(const ResidualContext& context, const BoardView& view);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  const ResidualContext& context_;
  const BoardView& view_;
};

/// Parameters as in CornerResiduals, then the laser's plane [3]. Residuals: one per point, its
/// offset from the plane, divided by that of a pixel across the line at the reference.
class LineResiduals : public ceres::CostFunction {
 public:
  LineResiduals(const ResidualContext& context, const BoardView& view, std::size_t index,
                std::size_t laser);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  const ResidualContext& context_;
  const BoardView& view_;
  std::size_t laser_;
  std::vector<double> scale_;  // [px] times the root of the weight; 0: left out
};

/// The correction of the flange [6], divided by the robot's noise.
class RobotResiduals : public ceres::CostFunction {
 public:
  RobotResiduals(const ResidualContext& context, const BoardView& view);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  const ResidualContext& context_;
  const BoardView& view_;
};

/// Camera [9]: prior that no term of the distortion moves the sensor's corner by much more than a
/// third of its distance from the middle. The prior only decides what the corners leave
/// undetermined.
class LensResiduals : public ceres::CostFunction {
 public:
  LensResiduals(const ResidualContext& context, bool square_pixels);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  Eigen::Matrix<double, 6, 9> rows_;
};

}  // namespace scan_calibration
