// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "camera_calibration.h"

#include "estimate/start.h"
#include "geometry/statistics.h"
#include "quality/uncertainty.h"

namespace scan_calibration {
namespace {

/// The camera alone as a joint estimate, so that its uncertainty is computed in the same way.
JointEstimate as_estimate(BoardViews views, const CameraFit& fit, bool square_pixels) {
  JointEstimate estimate;
  estimate.choice.robot = false;
  estimate.choice.square_pixels = square_pixels;
  estimate.state = fit.state;
  for (std::size_t i = 0; i < views.size(); ++i)
    views[i].measured = fit.camera_to_board[i].inverse();
  estimate.state.corrections.assign(views.size(), Vector6d::Zero());
  estimate.views = std::move(views);
  estimate.noise.levels = min_noise(0);
  estimate.noise.levels.corner_px = fit.corner_px;
  return estimate;
}

std::vector<ViewFigures> view_figures(const JointEstimate& estimate, const BoardSurface& surface,
                                      const std::vector<Eigen::Isometry3d>& boards) {
  std::vector<ViewFigures> result;
  for (std::size_t i = 0; i < estimate.views.size(); ++i) {
    const BoardView& view = estimate.views[i];
    ViewFigures figures;
    figures.name = view.name;
    figures.corner_residuals =
        corner_residuals(estimate.state, surface, board_sight(boards[i]), view);
    for (std::size_t k = 0; k < view.weights.size(); ++k)
      if (!(view.weights[k] > 0)) figures.left_out_corners.push_back(k);
    figures.reprojection_rms_px = rms_of(figures.corner_residuals, view.weights);
    result.push_back(figures);
  }
  return result;
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
  JointEstimate estimate = as_estimate(usable.views, found, options.square_pixels);
  result.views = view_figures(estimate, surface, found.camera_to_board);
  SquareSum all;
  for (std::size_t i = 0; i < result.views.size(); ++i)
    for (std::size_t k = 0; k < usable.views[i].weights.size(); ++k)
      if (usable.views[i].weights[k] > 0)
        all.add(result.views[i].corner_residuals[k].squaredNorm());
  result.reprojection_rms_px = all.rms();
  const NormalEquations equations(estimate.views, surface, estimate.noise.levels, estimate.choice,
                                  estimate.state);
  estimate.noise = estimate_noise(equations, given_noise({}, 0));
  Eigen::MatrixXd covariance;
  state_parameters(estimate.state, Knowledge(estimate, surface), {}, result.parameters, covariance);
  return result;
}

}  // namespace scan_calibration
