// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "geometry/sight.h"
#include "geometry/statistics.h"
#include "images/rough_camera.h"
#include "report/chart.h"
#include "report/report.h"
#include "sequential.h"

namespace scan_calibration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Places = Chart::Places;

constexpr int kWidth = 760, kHeight = 460;  // [px] of a picture, chosen

/// A chart of the image as seen: rows count downwards.
Chart image_chart(const Observations& seen) {
  const int height = 56 + (kWidth - 74) * seen.height / std::max(1, seen.width);
  return Chart(kWidth, height, {"column [px]", -0.5, seen.width - 0.5},
               {"row [px]", seen.height - 0.5, -0.5});
}

/// Shades the parts of the image, nine by nine, in which no corner was seen.
void shade_unseen(Chart& chart, const Observations& seen) {
  constexpr int kParts = 9;
  bool filled[kParts][kParts] = {};
  for (const ViewObservation& view : seen.views) {
    for (const SeenCorner& corner : view.corners) {
      const int column = static_cast<int>(kParts * (corner.pixel.x() + 0.5) / seen.width);
      const int row = static_cast<int>(kParts * (corner.pixel.y() + 0.5) / seen.height);
      filled[std::clamp(row, 0, kParts - 1)][std::clamp(column, 0, kParts - 1)] = true;
    }
  }
  const Vector2d part(static_cast<double>(seen.width) / kParts,
                      static_cast<double>(seen.height) / kParts);
  const auto at = [&](int column, int row) -> Vector2d {
    return part.cwiseProduct(Vector2d(column, row)) - Vector2d(0.5, 0.5);
  };
  for (int row = 0; row < kParts; ++row)
    for (int column = 0; column < kParts; ++column)
      if (!filled[row][column])
        chart.fill(
            {at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)},
            "#fae1e1");
}

ReportPicture coverage(const Observations& seen) {
  Chart chart = image_chart(seen);
  shade_unseen(chart, seen);
  for (std::size_t i = 0; i < seen.views.size(); ++i) {
    Places corners, lines;
    for (const SeenCorner& corner : seen.views[i].corners)
      corners.push_back(corner.pixel);
    for (const auto& line : seen.views[i].lines)
      for (std::size_t k = 0; k < line.size(); k += 8)
        lines.push_back(line[k]);
    chart.dots(corners, colour_of(i, seen.views.size()), 1.6);
    chart.dots(lines, "#787878", 1);
  }
  return {"coverage",
          "Where in the image the board's corners (one colour per view) and the laser lines (grey) "
          "were seen. Shaded: no corner; the lens is not known there.",
          chart.svg()};
}

ReportPicture residuals(const Observations& seen, const Calibration& calibration) {
  Chart chart = image_chart(seen);
  const ViewsByName views = by_name(seen);
  const double rms = std::max(1e-6, calibration.fitted.reprojection_rms_px);
  const double stretch = 10 / (rms * chart.scale());  // an RMS residual is 10 px long
  for (std::size_t i = 0; i < calibration.views.size(); ++i) {
    const ViewFigures& figures = calibration.views[i];
    const ViewObservation& view = *views.at(figures.name);
    const auto& left_out = figures.left_out_corners;
    Places places, vectors;
    for (std::size_t k = 0; k < view.corners.size() && k < figures.corner_residuals.size(); ++k) {
      if (std::find(left_out.begin(), left_out.end(), k) != left_out.end()) continue;
      places.push_back(view.corners[k].pixel);
      vectors.push_back(places.back());
      vectors.emplace_back(places.back() + stretch * figures.corner_residuals[k]);
    }
    chart.lines(vectors, colour_of(i, calibration.views.size()));
    chart.dots(places, colour_of(i, calibration.views.size()), 1.2);
  }
  return {
      "residuals",
      fmt::format("Residuals of the corners, {:.0f} times as long as they are. They should point "
                  "in all directions; vectors that agree over a region are an error of the "
                  "lens model or of the board.",
                  stretch),
      chart.svg()};
}

/// Corners of the board's outer squares in the camera, from the robot and the model, per view.
std::vector<std::vector<Vector3d>> outlines(const Observations& seen,
                                            const Calibration& calibration) {
  const Board& board = seen.board;
  std::vector<std::vector<Vector3d>> result;
  for (const ViewObservation& view : seen.views) {
    const Isometry3d pose = (view.base_to_flange * calibration.scanner.flange_to_camera).inverse() *
                            calibration.base_to_board;
    result.emplace_back();
    for (const auto& [column, row] :
         {std::pair(-1, -1), std::pair(board.columns, -1), std::pair(board.columns, board.rows),
          std::pair(-1, board.rows)})
      result.back().emplace_back(pose * (Vector3d(column, row, 0) * board.square_size));
  }
  return result;
}

/// From above (x, z) or from the side (y, z).
ReportPicture space(const Observations& seen, const Calibration& calibration, int axis) {
  const std::vector<std::vector<Vector3d>> boards = outlines(seen, calibration);
  double widest = 0.05, farthest = 0.1;  // [m] at least, chosen
  for (const auto& board : boards) {
    for (const Vector3d& corner : board) {
      widest = std::max(widest, std::abs(corner[axis]));
      farthest = std::max(farthest, corner.z());
    }
  }
  Chart chart(kWidth, kHeight,
              {fmt::format("{} [m] in camera_optical_frame", axis == 0 ? "x" : "y"), -1.1 * widest,
               1.1 * widest},
              {"z [m]", 1.05 * farthest, -0.03 * farthest});
  for (std::size_t i = 0; i < boards.size(); ++i) {
    Places flat;
    for (const Vector3d& corner : boards[i])
      flat.emplace_back(corner[axis], corner.z());
    chart.outline(flat, colour_of(i, boards.size()));
  }
  for (const auto& laser : calibration.scanner.lasers) {
    if (!laser) continue;
    // Where the plane cuts this section of space; one that lies nearly in it has no line
    const Vector2d normal(laser->normal[axis], laser->normal.z());
    if (normal.norm() < 0.2) continue;
    const Vector2d foot = normal * laser->distance / normal.squaredNorm();
    const Vector2d along = Vector2d(-normal.y(), normal.x()).normalized() * 2 * farthest;
    chart.lines({foot - along, foot + along}, "#dc0000", 2);
  }
  chart.dots({Vector2d(0, 0)}, "#000", 4);
  return {axis == 0 ? "space_above" : "space_side",
          fmt::format("The boards as the camera (black dot) saw them, {}, with the laser planes "
                      "(red).",
                      axis == 0 ? "from above" : "from the side"),
          chart.svg()};
}

/// Points of one laser on the boards [m, camera_optical_frame].
std::vector<Vector3d> points_of(const Observations& seen, const Calibration& calibration,
                                std::size_t laser) {
  std::vector<Vector3d> points;
  for (const ViewObservation& view : seen.views) {
    if (view.lines[laser].empty()) continue;
    BoardCorners corners(static_cast<std::size_t>(seen.board.columns * seen.board.rows),
                         Vector2d::Constant(std::nan("")));
    for (const SeenCorner& corner : view.corners)
      corners[corner.row * seen.board.columns + corner.column] = corner.pixel;
    const Isometry3d pose = rough_board_pose(calibration.scanner.camera, corners, seen.board);
    const Vector3d normal = pose.linear().col(2);
    for (const Vector2d& pixel : view.lines[laser])
      if (const auto ray = ray_of(calibration.scanner.camera, pixel))
        points.emplace_back(*ray * normal.dot(pose.translation()) / normal.dot(*ray));
  }
  return points;
}

ReportPicture plane(const Observations& seen, const Calibration& calibration, std::size_t laser) {
  const scan_cell_common::LaserPlane& model =
      calibration.scanner.laser(scan_cell_common::laser_index(seen.lasers[laser]));
  const Vector3d depth =
      (Vector3d::UnitZ() - model.normal * model.normal.z()).normalized();  // of the light
  const Vector3d side = depth.cross(model.normal);
  Places places;
  std::vector<double> off;
  SquareSum sum;
  Eigen::AlignedBox2d box;
  for (const Vector3d& point : points_of(seen, calibration, laser)) {
    places.emplace_back(side.dot(point), depth.dot(point));
    off.push_back(model.normal.dot(point) - model.distance);
    sum.add(off.back() * off.back());
    box.extend(places.back());
  }
  if (places.empty()) box = Eigen::AlignedBox2d(Vector2d(0, 0), Vector2d(1, 1));
  const double rms = places.empty() ? 0 : sum.rms();
  const double margin = 0.03 * box.sizes().maxCoeff() + 1e-6;
  Chart chart(kWidth, kHeight,
              {"along the line [m]", box.min().x() - margin, box.max().x() + margin},
              {"along the light [m]", box.max().y() + margin, box.min().y() - margin});
  std::map<std::string, Places> by_colour;
  for (std::size_t i = 0; i < places.size(); ++i)
    by_colour[colour_between(off[i] / std::max(1e-9, 2 * rms))].push_back(places[i]);
  for (const auto& [colour, part] : by_colour)
    chart.dots(part, colour, 1.8);
  return {
      "plane_" + seen.lasers[laser],
      fmt::format("The plane of {} with its points: grey on it, red and blue {:.3f} mm off it to "
                  "either side. A region of one colour is an error of the plane or of a view.",
                  seen.lasers[laser], 2e3 * rms),
      chart.svg()};
}

}  // namespace

std::vector<ReportPicture> report_pictures(const CalibrationRun& run) {
  if (run.calibration) {
    const Observations seen = used_views(run.observations, *run.calibration);
    std::vector<ReportPicture> pictures = {coverage(seen), space(seen, *run.calibration, 0),
                                           space(seen, *run.calibration, 1),
                                           residuals(seen, *run.calibration)};
    for (std::size_t laser = 0; laser < seen.lasers.size(); ++laser)
      pictures.push_back(plane(seen, *run.calibration, laser));
    return pictures;
  }
  if (run.observations.views.empty()) return {};
  return {coverage(run.observations)};
}

}  // namespace scan_calibration
