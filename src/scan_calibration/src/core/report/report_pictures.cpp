// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>

#include "images/rough_camera.h"
#include "report/chart.h"
#include "scan_calibration/calibration_files.h"

namespace scan_calibration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kWidth = 760;
const cv::Scalar kGrey(120, 120, 120);

/// A chart of the image, as it is seen: rows count downwards.
Chart image_chart(const Observations& seen) {
  const int height = 56 + (kWidth - 74) * seen.height / std::max(1, seen.width);
  return Chart(kWidth, height, {"column [px]", -0.5, seen.width - 0.5},
               {"row [px]", seen.height - 0.5, -0.5});
}

/// Shades the ninths of ninths of the image that no corner fell in.
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
  const double width = static_cast<double>(seen.width) / kParts;
  const double height = static_cast<double>(seen.height) / kParts;
  for (int row = 0; row < kParts; ++row) {
    for (int column = 0; column < kParts; ++column) {
      if (filled[row][column]) continue;
      chart.fill({column * width - 0.5, row * height - 0.5},
                 {(column + 1) * width - 0.5, (row + 1) * height - 0.5}, cv::Scalar(225, 225, 250));
    }
  }
}

ReportPicture coverage(const Observations& seen) {
  Chart chart = image_chart(seen);
  shade_unseen(chart, seen);
  for (std::size_t i = 0; i < seen.views.size(); ++i) {
    const cv::Scalar colour = colour_of(i, seen.views.size());
    for (const SeenCorner& corner : seen.views[i].corners)
      chart.dot(corner.pixel, colour, 1.6);
    for (const auto& line : seen.views[i].lines)
      for (std::size_t k = 0; k < line.size(); k += 8)
        chart.dot(line[k], kGrey, 1);
  }
  return {"coverage",
          "Where in the image the board's corners (a colour a view) and the laser lines (grey) "
          "were seen. Shaded: no corner; the lens is not known there.",
          chart.png(), ""};
}

ReportPicture residuals(const Observations& seen, const Calibration& calibration) {
  Chart chart = image_chart(seen);
  std::map<std::string, const ViewObservation*> views;
  for (const ViewObservation& view : seen.views)
    views[view.name] = &view;
  const double rms = std::max(1e-6, calibration.fitted.reprojection_rms_px);
  const double stretch = 10 / (rms * chart.scale());  // an RMS residual is 10 px long
  for (std::size_t i = 0; i < calibration.views.size(); ++i) {
    const ViewFigures& figures = calibration.views[i];
    const ViewObservation& view = *views.at(figures.name);
    const cv::Scalar colour = colour_of(i, calibration.views.size());
    for (std::size_t k = 0; k < view.corners.size() && k < figures.corner_residuals.size(); ++k) {
      const auto& left_out = figures.left_out_corners;
      if (std::find(left_out.begin(), left_out.end(), k) != left_out.end()) continue;
      const Vector2d& place = view.corners[k].pixel;
      chart.line(place, place + stretch * figures.corner_residuals[k], colour);
      chart.dot(place, colour, 1.2);
    }
  }
  char caption[200];
  std::snprintf(caption, sizeof caption,
                "Residuals of the corners, %.0f times as long as they are. They should point "
                "anywhere; vectors that agree over a region are an error of the lens model or of "
                "the board.",
                stretch);
  return {"residuals", caption, chart.png(), ""};
}

/// Board poses in the camera's frame, by the robot and the model.
std::vector<Isometry3d> boards_in_camera(const Observations& seen, const Calibration& calibration) {
  std::vector<Isometry3d> poses;
  for (const ViewObservation& view : seen.views)
    poses.push_back((view.base_to_flange * calibration.scanner.flange_to_camera).inverse() *
                    calibration.base_to_board);
  return poses;
}

std::vector<Vector3d> outline_of(const Board& board, const Isometry3d& pose) {
  const double x = board.columns * board.square_size, y = board.rows * board.square_size;
  const double s = -board.square_size;
  return {pose * Vector3d(s, s, 0), pose * Vector3d(x, s, 0), pose * Vector3d(x, y, 0),
          pose * Vector3d(s, y, 0)};
}

/// From above (x, z) or from the side (y, z).
ReportPicture space(const Observations& seen, const Calibration& calibration, int axis) {
  const std::vector<Isometry3d> poses = boards_in_camera(seen, calibration);
  double widest = 0.05, farthest = 0.1;
  for (const Isometry3d& pose : poses) {
    for (const Vector3d& corner : outline_of(seen.board, pose)) {
      widest = std::max(widest, std::abs(corner[axis]));
      farthest = std::max(farthest, corner.z());
    }
  }
  const std::string name = axis == 0 ? "x" : "y";
  Chart chart(kWidth, 460, {name + " [m] in camera_optical_frame", -1.1 * widest, 1.1 * widest},
              {"z [m]", 1.05 * farthest, -0.03 * farthest});
  for (std::size_t i = 0; i < poses.size(); ++i) {
    std::vector<Vector2d> flat;
    for (const Vector3d& corner : outline_of(seen.board, poses[i]))
      flat.emplace_back(corner[axis], corner.z());
    chart.outline(flat, colour_of(i, poses.size()));
  }
  for (std::size_t i = 0; i < calibration.scanner.lasers.size(); ++i) {
    if (!calibration.scanner.has_laser(i)) continue;
    const scan_cell_common::LaserPlane& laser = calibration.scanner.laser(i);
    // Where the plane meets this section of space; one that lies in it has no line.
    const Vector2d normal(laser.normal[axis], laser.normal.z());
    if (normal.norm() < 0.2) continue;
    const Vector2d foot = normal * laser.distance / normal.squaredNorm();
    const Vector2d along = Vector2d(-normal.y(), normal.x()).normalized() * 2 * farthest;
    chart.line(foot - along, foot + along, cv::Scalar(0, 0, 220), 2);
  }
  chart.dot({0, 0}, cv::Scalar(0, 0, 0), 4);
  return {axis == 0 ? "space_above" : "space_side",
          std::string("The boards as the camera (black dot) saw them, ") +
              (axis == 0 ? "from above" : "from the side") + ", with the laser planes (red).",
          chart.png(), ""};
}

/// Points of one laser on the boards [m, camera_optical_frame].
std::vector<Vector3d> laser_points(const Observations& seen, const Calibration& calibration,
                                   std::size_t laser) {
  const scan_cell_common::CameraIntrinsics& camera = calibration.scanner.camera;
  std::vector<Vector3d> points;
  for (const ViewObservation& view : seen.views) {
    if (view.lines[laser].empty()) continue;
    BoardCorners corners(static_cast<std::size_t>(seen.board.columns * seen.board.rows),
                         Vector2d::Constant(std::nan("")));
    for (const SeenCorner& corner : view.corners)
      corners[corner.row * seen.board.columns + corner.column] = corner.pixel;
    const Isometry3d pose = rough_board_pose(camera, corners, seen.board);
    const Vector3d normal = pose.linear().col(2);
    for (const Vector2d& pixel : view.lines[laser]) {
      const Vector2d distorted((pixel.x() - camera.cx) / camera.fx,
                               (pixel.y() - camera.cy) / camera.fy);
      Vector2d ray = distorted;
      if (!camera.undistort(distorted, ray)) continue;
      const Vector3d direction(ray.x(), ray.y(), 1);
      points.push_back(direction * normal.dot(pose.translation()) / normal.dot(direction));
    }
  }
  return points;
}

ReportPicture plane(const Observations& seen, const Calibration& calibration, std::size_t laser) {
  const scan_cell_common::LaserPlane& model =
      calibration.scanner.laser(scan_cell_common::laser_index(seen.lasers[laser]));
  const std::vector<Vector3d> points = laser_points(seen, calibration, laser);
  const Vector3d depth =
      (Vector3d::UnitZ() - model.normal * model.normal.z()).normalized();  // of the light
  const Vector3d side = depth.cross(model.normal);
  std::vector<Vector2d> places;
  std::vector<double> off;
  double low = 1e9, high = -1e9, near = 1e9, far = -1e9, sum = 0;
  for (const Vector3d& point : points) {
    places.emplace_back(side.dot(point), depth.dot(point));
    off.push_back(model.normal.dot(point) - model.distance);
    sum += off.back() * off.back();
    low = std::min(low, places.back().x());
    high = std::max(high, places.back().x());
    near = std::min(near, places.back().y());
    far = std::max(far, places.back().y());
  }
  if (points.empty()) low = near = 0, high = far = 1;
  const double rms = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, off.size())));
  const double margin = 0.03 * std::max(high - low, far - near) + 1e-6;
  Chart chart(kWidth, 460, {"along the line [m]", low - margin, high + margin},
              {"along the light [m]", far + margin, near - margin});
  for (std::size_t i = 0; i < places.size(); ++i)
    chart.dot(places[i], colour_between(off[i] / std::max(1e-9, 2 * rms)), 1.8);
  char caption[200];
  std::snprintf(caption, sizeof caption,
                "The plane of %s with its points: grey on it, red and blue %.3f mm off it to "
                "either side. A region of one colour is an error of the plane or of a view.",
                seen.lasers[laser].c_str(), 2e3 * rms);
  return {"plane_" + seen.lasers[laser], caption, chart.png(), ""};
}

}  // namespace

std::vector<ReportPicture> report_pictures(const CalibrationRun& run, const std::string& stem) {
  std::vector<ReportPicture> pictures;
  if (run.calibration) {
    const Observations seen = used_views(run.observations, *run.calibration);
    pictures = {coverage(seen), space(seen, *run.calibration, 0), space(seen, *run.calibration, 1),
                residuals(seen, *run.calibration)};
    for (std::size_t laser = 0; laser < seen.lasers.size(); ++laser)
      pictures.push_back(plane(seen, *run.calibration, laser));
  } else if (!run.observations.views.empty()) {
    pictures = {coverage(run.observations)};
  }
  for (ReportPicture& picture : pictures)
    picture.file = stem + "_" + picture.name + ".png";
  return pictures;
}

}  // namespace scan_calibration
