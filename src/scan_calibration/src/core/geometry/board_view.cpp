// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/board_view.h"

#include <limits>

#include "geometry/statistics.h"

namespace scan_calibration {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

LinePoints thinned(const std::vector<Eigen::Vector2d>& points) {
  constexpr std::size_t kMaxPoints = 100;  // chosen: neighbours share their errors
  LinePoints line;
  line.index = evenly(points.size(), kMaxPoints);
  for (const std::size_t index : line.index)
    line.pixels.push_back(points[index]);
  line.weights.assign(line.index.size(), 1);
  return line;
}

}  // namespace

BoardView board_view(const Observations& observations, std::size_t index) {
  const ViewObservation& view = observations.views[index];
  BoardView result;
  result.name = view.name;
  result.source = index;
  result.measured = view.base_to_flange;
  for (const SeenCorner& corner : view.corners) {
    result.places.push_back(Eigen::Vector2d(corner.column, corner.row) *
                            observations.board.square_size);
    result.pixels.push_back(corner.pixel);
  }
  result.weights.assign(view.corners.size(), 1);
  for (const std::vector<Eigen::Vector2d>& line : view.lines)
    result.lines.push_back(thinned(line));
  return result;
}

void turn_half(BoardView& view, const BoardSurface& surface) {
  for (Eigen::Vector2d& place : view.places)
    place = 2 * surface.centre() - place;
}

BoardSight sight_of(const ScannerState& state, const BoardView& view, std::size_t index) {
  const Eigen::Isometry3d camera =
      moved(view.measured, state.corrections[index]) * state.flange_to_camera;
  return board_sight(camera.inverse() * state.base_to_board);
}

std::vector<Eigen::Vector2d> corner_residuals(const ScannerState& state,
                                              const BoardSurface& surface, const BoardSight& sight,
                                              const BoardView& view) {
  std::vector<Eigen::Vector2d> residuals(view.pixels.size(), Eigen::Vector2d::Constant(kNone));
  Projection projection;
  for (std::size_t i = 0; i < view.pixels.size(); ++i) {
    const Eigen::Vector3d point =
        sight.rotation * on_board(surface, state.bend, view.places[i]) + sight.position;
    if (project(state.camera, point, projection)) residuals[i] = view.pixels[i] - projection.pixel;
  }
  return residuals;
}

std::vector<double> line_residuals(const ScannerState& state, const BoardSurface& surface,
                                   const BoardSight& sight, const LinePoints& line,
                                   std::size_t laser) {
  std::vector<double> residuals(line.pixels.size(), kNone);
  LineOffset offset;
  for (std::size_t i = 0; i < line.pixels.size(); ++i) {
    if (line_offset(state, surface, sight, line.pixels[i], state.planes[laser], offset))
      residuals[i] = offset.pixels();
  }
  return residuals;
}

}  // namespace scan_calibration
