// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "estimate/synthetic_session.h"

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <random>

namespace synthetic {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using scan_calibration::Observations;
using scan_calibration::ViewObservation;

Vector2d project(const scan_cell_common::CameraIntrinsics& camera, const Vector3d& point) {
  const cv::Matx33d matrix(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const std::vector<double> distortion(camera.distortion.begin(), camera.distortion.end());
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(std::vector<cv::Point3d>{{point.x(), point.y(), point.z()}}, cv::Vec3d(),
                    cv::Vec3d(), matrix, distortion, pixels);
  return {pixels[0].x, pixels[0].y};
}

bool within(const scan_cell_common::CameraIntrinsics& camera, const Vector2d& pixel) {
  return pixel.x() > 0 && pixel.y() > 0 && pixel.x() < camera.width - 1 &&
         pixel.y() < camera.height - 1;
}

/// Height of the bent board.
double height(const Cell& cell, const Vector2d& place) {
  const Vector2d half =
      Vector2d(cell.board.columns - 1, cell.board.rows - 1) * cell.board.square_size / 2;
  const Vector2d unit = (place - half).cwiseQuotient(half);
  const auto mean = [](int count) {
    double sum = 0;
    for (int i = 0; i < count; ++i)
      sum += std::pow(2. * i / (count - 1) - 1, 2) / count;
    return sum;
  };
  return cell.bend[0] * (unit.x() * unit.x() - mean(cell.board.columns)) +
         cell.bend[1] * unit.x() * unit.y() +
         cell.bend[2] * (unit.y() * unit.y() - mean(cell.board.rows));
}

/// Where a laser's light lies on the board [m], from one side to the other.
std::vector<Vector2d> lit(const Cell& cell, const scan_cell_common::LaserPlane& laser,
                          const Isometry3d& camera_to_board) {
  const Vector2d far =
      Vector2d(cell.board.columns - 1, cell.board.rows - 1) * cell.board.square_size;
  const Vector3d normal = camera_to_board.linear().transpose() * laser.normal;
  const double distance = laser.distance - laser.normal.dot(camera_to_board.translation());
  const bool along_x = std::abs(normal.y()) > std::abs(normal.x());
  constexpr int kPoints = 150;
  std::vector<Vector2d> places;
  for (int i = 0; i <= kPoints; ++i) {
    Vector2d place = far * i / kPoints;
    for (int step = 0; step < 5; ++step) {  // the height hangs on the place
      const double left = distance - normal.z() * height(cell, place);
      if (along_x) place.y() = (left - normal.x() * place.x()) / normal.y();
      if (!along_x) place.x() = (left - normal.y() * place.y()) / normal.x();
    }
    if ((place.array() >= 0).all() && (place.array() <= far.array()).all()) places.push_back(place);
  }
  return places;
}

}  // namespace

Cell::Cell() : base_to_board(Isometry3d::Identity()), board{25, 15, 0.02} {
  scanner.camera.width = 1696;
  scanner.camera.height = 1710;
  scanner.camera.fx = 801.3;
  scanner.camera.fy = 800.6;
  scanner.camera.cx = 851.2;
  scanner.camera.cy = 852.7;
  scanner.camera.distortion << -0.081, 0.052, 0.0006, -0.0004, 0.003;
  scanner.flange_to_camera.linear() =
      Eigen::Quaterniond(0.99994, 0.006, -0.0045, 0.0075).normalized().toRotationMatrix();
  scanner.flange_to_camera.translation() << 0.004, -0.003, 0.085;
  for (const double side : {-1., 1.}) {
    scan_cell_common::LaserPlane laser;
    laser.origin << 0.25 * side, 0, 0.012;
    laser.normal = Vector3d(-0.89 * side, -0.001, -0.456).normalized();
    laser.distance = laser.normal.dot(laser.origin);
    scanner.lasers.push_back(laser);
  }
  base_to_board.linear() = (Eigen::AngleAxisd(0.2, Vector3d::UnitZ()) *
                            Eigen::AngleAxisd(M_PI - 0.01, Vector3d::UnitX()))
                               .toRotationMatrix();
  base_to_board.translation() << 0.7, 0.1, 0.05;
}

std::vector<Isometry3d> flange_poses(const Cell& cell, const Poses& poses) {
  std::mt19937 generator(poses.seed);
  const auto uniform = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(generator);
  };
  const Vector3d middle(0.5 * (cell.board.columns - 1) * cell.board.square_size,
                        0.5 * (cell.board.rows - 1) * cell.board.square_size, 0);
  std::vector<Isometry3d> flange;
  for (int i = 0; i < poses.count; ++i) {
    const double direction = uniform(-M_PI, M_PI);
    const Vector3d axis(std::cos(direction), std::sin(direction), 0);
    Isometry3d camera_to_board = Isometry3d::Identity();
    camera_to_board.linear() =
        (Eigen::AngleAxisd(poses.max_tilt * std::sqrt(uniform(0, 1)), axis) *
         Eigen::AngleAxisd(uniform(-poses.max_roll, poses.max_roll), Vector3d::UnitZ()))
            .toRotationMatrix();
    const Vector3d centre(uniform(-poses.aside, poses.aside), uniform(-poses.aside, poses.aside),
                          uniform(poses.nearest, poses.farthest));
    camera_to_board.translation() = centre - camera_to_board.linear() * middle;
    flange.push_back(cell.base_to_board * camera_to_board.inverse() *
                     cell.scanner.flange_to_camera.inverse());
  }
  return flange;
}

Observations observe(const Cell& cell, const std::vector<Isometry3d>& flange, const Noise& noise,
                     unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  const auto gauss = [&](double deviation) { return deviation * normal(generator); };
  Observations result;
  result.width = cell.scanner.camera.width;
  result.height = cell.scanner.camera.height;
  result.board = cell.board;
  for (std::size_t laser = 0; laser < cell.scanner.lasers.size(); ++laser)
    result.lasers.push_back("laser_" + std::to_string(laser));
  for (std::size_t i = 0; i < flange.size(); ++i) {
    ViewObservation view;
    view.name = "view" + std::to_string(i);
    const Isometry3d camera_to_board =
        (flange[i] * cell.scanner.flange_to_camera).inverse() * cell.base_to_board;
    for (int row = 0; row < cell.board.rows; ++row)
      for (int column = 0; column < cell.board.columns; ++column) {
        const Vector2d place = Vector2d(column, row) * cell.board.square_size;
        const Vector3d point =
            camera_to_board * Vector3d(place.x(), place.y(), height(cell, place));
        const Vector2d pixel = project(cell.scanner.camera, point);
        if (point.z() > 0 && within(cell.scanner.camera, pixel))
          view.corners.push_back(
              {column, row, pixel + Vector2d(gauss(noise.corner_px), gauss(noise.corner_px))});
      }
    for (std::size_t laser = 0; laser < cell.scanner.lasers.size(); ++laser) {
      view.lines.emplace_back();
      for (const Vector2d& place : lit(cell, cell.scanner.laser(laser), camera_to_board)) {
        const Vector2d pixel =
            project(cell.scanner.camera,
                    camera_to_board * Vector3d(place.x(), place.y(), height(cell, place)));
        if (within(cell.scanner.camera, pixel))
          view.lines.back().push_back(pixel + Vector2d(gauss(noise.line_px), 0));
      }
    }
    const Vector3d turn(gauss(noise.robot_rad), gauss(noise.robot_rad), gauss(noise.robot_rad));
    view.base_to_flange = flange[i];
    if (turn.norm() > 0)
      view.base_to_flange.rotate(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
    view.base_to_flange.pretranslate(
        Vector3d(gauss(noise.robot_m), gauss(noise.robot_m), gauss(noise.robot_m)));
    result.views.push_back(view);
  }
  return result;
}

Observations goal_session(const Cell& cell, unsigned seed) {
  Poses poses;
  poses.seed = 1000 + seed;
  return observe(cell, flange_poses(cell, poses), {0.1, 0.1, 5e-5, 5e-5}, seed);
}

}  // namespace synthetic
