// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "actions/calibration_markers.h"

#include <algorithm>
#include <array>
#include <opencv2/calib3d.hpp>
#include <optional>
#include <vector>

#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_cell {

using scan_calibration::Board;
using scan_calibration::Calibration;
using scan_calibration::ViewObservation;
using scan_cell_common::CameraIntrinsics;
using scan_cell_common::LaserPlane;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace {

using Points = std::vector<Eigen::Vector3d>;

struct Colour {
  float r, g, b, a;
};

constexpr std::array<Colour, 2> kLasers = {{{0.9F, 0.1F, 0.1F, 1}, {0.1F, 0.55F, 0.1F, 1}}};
constexpr Colour kBoard = {0.1F, 0.1F, 0.6F, 0.6F};
constexpr Colour kCamera = {0.4F, 0.4F, 0.4F, 0.6F};
constexpr double kLine = 0.0005;  // [m] wide; chosen

Marker marker(const std::string& frame, const std::string& name, int type, const Colour& colour,
              const Points& points) {
  Marker result;
  result.header.frame_id = frame;
  result.ns = name;
  result.type = type;
  result.action = Marker::ADD;
  result.pose.orientation.w = 1;
  result.frame_locked = static_cast<unsigned char>(true);  // planes move with the flange
  const bool triangles = type == Marker::TRIANGLE_LIST;
  result.scale.x = result.scale.y = result.scale.z = triangles ? 1 : kLine;
  result.color.r = colour.r;
  result.color.g = colour.g;
  result.color.b = colour.b;
  result.color.a = colour.a;
  for (const Eigen::Vector3d& point : points) {
    geometry_msgs::Point p;
    p.x = point.x();
    p.y = point.y();
    p.z = point.z();
    result.points.push_back(p);
  }
  return result;
}

/// Ends of the lines between neighbours in a closed polygon.
Points edges(const Points& corners) {
  Points ends;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    ends.push_back(corners[i]);
    ends.push_back(corners[(i + 1) % corners.size()]);
  }
  return ends;
}

std::optional<Eigen::Vector3d> ray_at(const CameraIntrinsics& camera,
                                      const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d distorted((pixel.x() - camera.cx) / camera.fx,
                                  (pixel.y() - camera.cy) / camera.fy);
  Eigen::Vector2d ray = distorted;
  if (!camera.undistort(distorted, ray)) return std::nullopt;
  return Eigen::Vector3d(ray.x(), ray.y(), 1);
}

/// Points on a plane of light in the camera's frame.
Points points_on(const LaserPlane& laser, const CameraIntrinsics& camera,
                 const std::vector<Eigen::Vector2d>& pixels) {
  Points points;
  for (const Eigen::Vector2d& pixel : pixels) {
    const auto ray = ray_at(camera, pixel);
    if (ray) points.push_back(*ray * (laser.distance / laser.normal.dot(*ray)));
  }
  return points;
}

/// Two triangles of the plane over the depth range of its points, in the camera's frame.
Points plane_patch(const LaserPlane& laser, const Points& points) {
  constexpr double kMargin = 0.05;  // [m] chosen
  const Eigen::Vector3d across = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d along = laser.normal.cross(across).normalized();
  const Eigen::Vector3d width = along.cross(laser.normal).normalized();
  double a0 = 1e9, a1 = -1e9, w0 = 1e9, w1 = -1e9;
  for (const Eigen::Vector3d& point : points) {
    a0 = std::min(a0, along.dot(point));
    a1 = std::max(a1, along.dot(point));
    w0 = std::min(w0, width.dot(point));
    w1 = std::max(w1, width.dot(point));
  }
  const auto at = [&](double a, double w) -> Eigen::Vector3d {
    return laser.normal * laser.distance + along * a + width * w;
  };
  const Points corners = {at(a0 - kMargin, w0 - kMargin), at(a1 + kMargin, w0 - kMargin),
                          at(a1 + kMargin, w1 + kMargin), at(a0 - kMargin, w1 + kMargin)};
  return {corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]};
}

Points moved(const Eigen::Isometry3d& pose, Points points) {
  for (Eigen::Vector3d& point : points)
    point = pose * point;
  return points;
}

/// The board in the camera's frame from this view alone.
std::optional<Eigen::Isometry3d> board_in_camera(const CameraIntrinsics& camera, const Board& board,
                                                 const ViewObservation& view) {
  std::vector<cv::Point3d> places;
  std::vector<cv::Point2d> pixels;
  for (const scan_calibration::SeenCorner& corner : view.corners) {
    places.emplace_back(corner.column * board.square_size, corner.row * board.square_size, 0);
    pixels.emplace_back(corner.pixel.x(), corner.pixel.y());
  }
  const cv::Matx33d matrix(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const cv::Mat distortion = (cv::Mat_<double>(1, 5) << camera.distortion[0], camera.distortion[1],
                              camera.distortion[2], camera.distortion[3], camera.distortion[4]);
  cv::Vec3d turn, shift;
  if (places.size() < 4 || !cv::solvePnP(places, pixels, matrix, distortion, turn, shift)) {
    return std::nullopt;
  }
  const Eigen::Vector3d axis(turn[0], turn[1], turn[2]);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << shift[0], shift[1], shift[2];
  if (axis.norm() > 0) pose.linear() = Eigen::AngleAxisd(axis.norm(), axis.normalized()).matrix();
  return pose;
}

Points outline(const Board& board) {
  const double x = (board.columns - 1) * board.square_size;
  const double y = (board.rows - 1) * board.square_size;
  return edges({{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}});
}

/// The pyramid of the camera's field of view, a little way in front of it.
Points frustum(const CameraIntrinsics& camera) {
  constexpr double kDepth = 0.06;  // [m] chosen
  const double x0 = -camera.cx / camera.fx, x1 = (camera.width - camera.cx) / camera.fx;
  const double y0 = -camera.cy / camera.fy, y1 = (camera.height - camera.cy) / camera.fy;
  Points corners = {{x0, y0, 1}, {x1, y0, 1}, {x1, y1, 1}, {x0, y1, 1}};
  for (Eigen::Vector3d& corner : corners)
    corner *= kDepth;
  Points ends = edges(corners);
  for (const Eigen::Vector3d& corner : corners) {
    ends.emplace_back(0, 0, 0);
    ends.push_back(corner);
  }
  return ends;
}

bool is_used(const Calibration& calibration, const std::string& view) {
  return std::any_of(calibration.views.begin(), calibration.views.end(),
                     [&](const auto& used) { return used.name == view; });
}

}  // namespace

MarkerArray calibration_markers(const scan_calibration::CalibrationRun& run,
                                const std::string& base_frame) {
  const Calibration& calibration = *run.calibration;
  const scan_calibration::Observations& seen = run.observations;
  const CameraIntrinsics& camera = calibration.scanner.camera;
  const Eigen::Isometry3d& flange_to_camera = calibration.scanner.flange_to_camera;
  std::vector<Points> on_planes(seen.lasers.size());
  const auto plane = [&](std::size_t i) -> const LaserPlane& {
    return calibration.scanner.laser(scan_cell_common::laser_index(seen.lasers[i]));
  };
  MarkerArray array;
  array.markers.emplace_back();
  array.markers.back().action = Marker::DELETEALL;
  for (const ViewObservation& view : seen.views) {
    if (!is_used(calibration, view.name)) continue;
    const Eigen::Isometry3d base_to_camera = view.base_to_flange * flange_to_camera;
    array.markers.push_back(marker(base_frame, "camera " + view.name, Marker::LINE_LIST, kCamera,
                                   moved(base_to_camera, frustum(camera))));
    if (const auto board = board_in_camera(camera, seen.board, view)) {
      array.markers.push_back(marker(base_frame, "board " + view.name, Marker::LINE_LIST, kBoard,
                                     moved(base_to_camera * *board, outline(seen.board))));
    }
    for (std::size_t i = 0; i < on_planes.size() && i < view.lines.size(); ++i) {
      const Points points = points_on(plane(i), camera, view.lines[i]);
      on_planes[i].insert(on_planes[i].end(), points.begin(), points.end());
    }
  }
  for (std::size_t i = 0; i < on_planes.size(); ++i) {
    if (on_planes[i].empty()) continue;
    const std::size_t number = scan_cell_common::laser_index(seen.lasers[i]);
    Colour colour = kLasers[number % kLasers.size()];
    array.markers.push_back(marker("tool0", "points of " + seen.lasers[i], Marker::POINTS, colour,
                                   moved(flange_to_camera, on_planes[i])));
    colour.a = 0.25F;
    array.markers.push_back(marker("tool0", "plane of " + seen.lasers[i], Marker::TRIANGLE_LIST,
                                   colour,
                                   moved(flange_to_camera, plane_patch(plane(i), on_planes[i]))));
  }
  return array;
}

}  // namespace scan_cell
