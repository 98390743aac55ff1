// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "estimate/start.h"

#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "estimate/known_camera.h"
#include "estimate/laser_start.h"
#include "estimate/rejection.h"
#include "geometry/statistics.h"
#include "residuals/noise_components.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

using Eigen::Isometry3d;

PosePairs pairs_of(const BoardViews& views, const CameraFit& camera) {
  PosePairs pairs;
  for (std::size_t i = 0; i < views.size(); ++i) {
    pairs.names.push_back(views[i].name);
    pairs.flange.push_back(views[i].measured);
    pairs.board.push_back(camera.camera_to_board[i]);
  }
  return pairs;
}

/// Leaves out views that do not fit, and corrects those counted from the board's other end.
void keep_agreeing(const HandEye& hand_eye, const BoardSurface& surface, Start& start,
                   CameraFit& camera) {
  BoardViews kept;
  std::vector<Isometry3d> boards;
  for (std::size_t i = 0; i < start.views.size(); ++i) {
    BoardView& view = start.views[i];
    if (!hand_eye.fits[i]) {
      start.rejected.push_back(
          {view.name, "",
           fmt::format("its pose puts the board {} and {} from where the other views have it",
                       millimetres(hand_eye.offset[i]), degrees(hand_eye.angle[i]))});
      continue;
    }
    Isometry3d board = camera.camera_to_board[i];
    if (hand_eye.turned[i]) {
      turn_half(view, surface);
      board = board * surface.half_turn();
    }
    kept.push_back(std::move(view));
    boards.push_back(board);
  }
  start.views = std::move(kept);
  camera.camera_to_board = std::move(boards);
}

/// Motion from one pose to another.
Vector6d motion_between(const Isometry3d& from, const Isometry3d& to) {
  const Isometry3d step = from.inverse() * to;
  Vector6d motion;
  motion << step.translation(), rotation_vector(step.linear());
  return motion;
}

void start_lasers(const Observations& observations, const CameraFit& camera,
                  const BoardSurface& surface, Start& start) {
  for (std::size_t laser = 0; laser < observations.lasers.size(); ++laser) {
    const std::string& name = observations.lasers[laser];
    const PlaneFit plane = fit_plane(
        laser_points(start.state, surface, start.views, camera.camera_to_board, laser, name));
    check_plane(plane, name);
    start.state.planes.emplace_back(plane.normal / plane.distance);
  }
}

/// Robust deviations, from what each view alone shows.
NoiseLevels start_noise(const Start& start, const CameraFit& camera, const BoardSurface& surface) {
  NoiseLevels noise = min_noise(start.state.planes.size());
  noise.corner_px = std::max(noise.corner_px, camera.corner_px);
  std::vector<double> shifts, turns;
  for (const Vector6d& correction : start.state.corrections) {
    shifts.push_back(correction.head<3>().norm() / kMedianLength3);
    turns.push_back(correction.tail<3>().norm() / kMedianLength3);
  }
  noise.robot_m = std::max(noise.robot_m, median(shifts));
  noise.robot_rad = std::max(noise.robot_rad, median(turns));
  for (std::size_t laser = 0; laser < start.state.planes.size(); ++laser) {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < start.views.size(); ++i)
      for (const double residual :
           line_residuals(start.state, surface, sight_of(start.state, start.views[i], i),
                          start.views[i].lines[laser], laser))
        if (std::isfinite(residual)) lengths.push_back(std::abs(residual) * kDeviationPerMedian);
    noise.line_px[laser] = std::max(noise.line_px[laser], median(lengths));
  }
  return noise;
}

/// The camera's pose on the flange, and the board's in the base.
HandEye sight_hand_eye(const PosePairs& pairs, const BoardSurface& surface, const Board& board,
                       std::optional<KnownCamera>& known, std::string& note) {
  if (known) {
    const HandEye hand_eye = known->hand_eye(pairs);
    note = known->note();
    return hand_eye;
  }
  check_tilts(pairs);
  const HandEye hand_eye = agreed_hand_eye(pairs, surface);
  check_board_size(hand_eye, pairs, board.square_size);
  return hand_eye;
}

}  // namespace

CameraFit fit_and_reject(BoardViews& views, const BoardSurface& surface,
                         const std::function<CameraFit(BoardViews&)>& fit,
                         std::vector<RejectedView>& rejected) {
  CameraFit camera = fit(views);
  std::vector<BoardSight> sights;
  for (const Isometry3d& board : camera.camera_to_board)
    sights.push_back(board_sight(board));
  const std::vector<std::string> reasons = misfit_corners(camera.state, surface, sights, views);
  BoardViews kept;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (reasons[i].empty()) {
      kept.push_back(std::move(views[i]));
    } else {
      rejected.push_back({views[i].name, "", reasons[i]});
    }
  }
  const bool same = kept.size() == views.size();
  views = std::move(kept);
  if (same) return camera;
  check_enough(views, rejected);
  return fit(views);
}

Start closed_form_start(const Observations& observations, const CalibrationOptions& options) {
  const BoardSurface surface(observations.board);
  std::optional<KnownCamera> known;
  if (options.lasers_alone) known.emplace(*options.existing, observations);
  UsableViews usable = usable_views(observations);
  Start start{std::move(usable.views), {}, {}, std::move(usable.rejected), {}};
  CameraFit camera = fit_and_reject(
      start.views, surface,
      [&](BoardViews& views) {
        return known ? known->fit(views)
                     : fit_camera(views, surface, observations.width, observations.height, false,
                                  true);
      },
      start.rejected);
  if (known) known->check_lens(start.views, camera);
  for (BoardView& view : start.views)  // a fit of the camera alone has its own
    view.measured = observations.views[view.source].base_to_flange;
  const HandEye hand_eye =
      sight_hand_eye(pairs_of(start.views, camera), surface, observations.board, known, start.note);
  keep_agreeing(hand_eye, surface, start, camera);
  check_enough(start.views, start.rejected);

  start.state = camera.state;
  start.state.flange_to_camera = hand_eye.flange_to_camera;
  start.state.base_to_board = hand_eye.base_to_board;
  start.state.corrections.clear();
  for (std::size_t i = 0; i < start.views.size(); ++i) {
    const Isometry3d flange = start.state.base_to_board * camera.camera_to_board[i].inverse() *
                              start.state.flange_to_camera.inverse();
    start.state.corrections.push_back(motion_between(start.views[i].measured, flange));
  }
  start_lasers(observations, camera, surface, start);
  start.noise = start_noise(start, camera, surface);
  return start;
}

}  // namespace scan_calibration
