// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "camera_calibration.h"

#include <cmath>

#include "estimate/start.h"
#include "quality/uncertainty.h"

namespace scan_calibration {
namespace {

/// The estimate of a camera alone, so that its uncertainty is found as of any other.
JointEstimate as_estimate(BoardViews views, const CameraFit& fit, bool square_pixels) {
  JointEstimate estimate;
  estimate.choice.robot = false;
  estimate.choice.square_pixels = square_pixels;
  estimate.state = fit.state;
  for (std::size_t i = 0; i < views.size(); ++i)
    views[i].measured = fit.camera_to_board[i].inverse();
  estimate.state.corrections.assign(views.size(), Vector6d::Zero());
  estimate.views = std::move(views);
  estimate.noise.levels = least_noise(0);
  estimate.noise.levels.corner_px = fit.corner_px;
  return estimate;
}

}  // namespace

CameraCalibration calibrate_camera(const Observations& observations, const CameraOptions& options) {
  UsableViews usable = usable_board_views(observations);
  const BoardSurface surface(observations.board);
  check_enough(usable.views, usable.rejected);
  const auto fit = [&](BoardViews& views, bool robust) {
    return fit_camera(views, surface, observations.width, observations.height,
                      options.square_pixels, robust);
  };
  CameraFit found = options.reject_views
                        ? fit_and_reject(
                              usable.views, surface,
                              [&](BoardViews& views) { return fit(views, true); }, usable.rejected)
                        : fit(usable.views, false);
  check_tilts({{}, {}, found.camera_to_board});

  CameraCalibration result;
  result.camera = found.state.intrinsics();
  result.rejected = usable.rejected;
  const JointEstimate estimate = as_estimate(usable.views, found, options.square_pixels);
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < estimate.views.size(); ++i) {
    const BoardView& view = estimate.views[i];
    ViewFigures figures;
    figures.name = view.name;
    figures.corner_residuals =
        corner_residuals(estimate.state, surface, board_sight(found.camera_to_board[i]), view);
    for (std::size_t k = 0; k < view.weights.size(); ++k) {
      if (!(view.weights[k] > 0)) figures.left_out_corners.push_back(k);
      if (!(view.weights[k] > 0)) continue;
      squares += figures.corner_residuals[k].squaredNorm();
      count += 1;
    }
    figures.reprojection_rms_px = rms_of(figures.corner_residuals, view.weights);
    result.views.push_back(figures);
  }
  result.reprojection_rms_px = std::sqrt(squares / count);
  Eigen::MatrixXd covariance;
  JointEstimate weighted = estimate;
  const NormalEquations equations(weighted.views, surface, weighted.noise.levels, weighted.choice,
                                  weighted.state);
  weighted.noise = estimate_noise(equations, given_noise({}, 0), unbounded_noise(0));
  state_parameters(weighted.state, Knowledge(weighted, surface), {}, result.parameters, covariance);
  return result;
}

}  // namespace scan_calibration
