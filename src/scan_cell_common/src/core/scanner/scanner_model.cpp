// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/scanner/scanner_model.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {
namespace {

void refuse(const std::string& entry, const std::string& value, const std::string& cure) {
  throw scan_cell_common::UnusableInput("scanner model: " + entry, value, cure);
}

void check(const CameraIntrinsics& camera) {
  constexpr int kMost = 16384;  // pixels a side
  if (camera.width < 1 || camera.height < 1 || camera.width > kMost || camera.height > kMost) {
    refuse("camera size", fmt::format("{} x {}", camera.width, camera.height),
           "give the sensor's columns and rows");
  }
  constexpr std::int64_t kMaxPixels = std::int64_t{1} << 26;
  if (std::int64_t{camera.width} * camera.height > kMaxPixels) {
    refuse("camera size", fmt::format("{} x {}", camera.width, camera.height),
           "no camera has more than 64 million pixels: check it");
  }
  if (!(camera.fx > 0) || !(camera.fy > 0) || !std::isfinite(camera.fx + camera.fy)) {
    refuse("camera fx, fy", fmt::format("{:g}, {:g}", camera.fx, camera.fy),
           "give focal lengths in pixels, above 0");
  }
  if (!std::isfinite(camera.cx + camera.cy) || !camera.distortion.allFinite()) {
    refuse("camera cx, cy, distortion", "not finite", "calibrate the camera again");
  }
}

void check(const LaserPlane& laser, const std::string& name) {
  constexpr double kUnit = 1e-6;
  constexpr double kInPlane = 1e-3;
  if (!laser.normal.allFinite() || std::abs(laser.normal.norm() - 1) > kUnit) {
    refuse(name + " plane normal", fmt::format("length {:.9g}", laser.normal.norm()),
           "give a unit normal");
  }
  if (!(std::abs(laser.normal.dot(laser.origin) - laser.distance) < kInPlane)) {
    refuse(name + " origin",
           fmt::format("{:.3g} m off its plane", laser.normal.dot(laser.origin) - laser.distance),
           "give a point of the plane");
  }
  if (std::abs(laser.distance) < kInPlane) {
    refuse(name + " plane distance", fmt::format("{:.3g} m", laser.distance),
           "a plane through the camera's centre shows no depth: calibrate the laser again");
  }
}

}  // namespace

Eigen::Vector2d CameraIntrinsics::distort(const Eigen::Vector2d& ray) const {
  const double x = ray.x();
  const double y = ray.y();
  const double k1 = distortion[0], k2 = distortion[1], p1 = distortion[2], p2 = distortion[3],
               k3 = distortion[4];
  const double r2 = x * x + y * y;
  const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
          y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y};
}

bool CameraIntrinsics::undistort(const Eigen::Vector2d& distorted, Eigen::Vector2d& ray) const {
  const double k1 = distortion[0], k2 = distortion[1], p1 = distortion[2], p2 = distortion[3],
               k3 = distortion[4];
  constexpr int kMaxSteps = 20;
  constexpr double kConverged = 1e-7;  // each step squares the error, so 1e-14 remains
  double x = ray.x();
  double y = ray.y();
  for (int step = 0; step < kMaxSteps; ++step) {
    const double r2 = x * x + y * y;
    const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    const double slope = k1 + r2 * (2 * k2 + r2 * 3 * k3);  // of radial, over r2
    const double error_x = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x) - distorted.x();
    const double error_y = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y - distorted.y();
    const double xx = radial + 2 * x * x * slope + 2 * p1 * y + 6 * p2 * x;
    const double xy = 2 * x * y * slope + 2 * p1 * x + 2 * p2 * y;
    const double yy = radial + 2 * y * y * slope + 6 * p1 * y + 2 * p2 * x;
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0) || !(xx + yy > 0)) return false;
    const double step_x = (yy * error_x - xy * error_y) / determinant;
    const double step_y = (xx * error_y - xy * error_x) / determinant;
    x -= step_x;
    y -= step_y;
    if (std::abs(step_x) + std::abs(step_y) < kConverged) {
      ray = {x, y};
      return true;
    }
  }
  return false;
}

bool CameraIntrinsics::contains(const Eigen::Vector2d& pixel) const {
  constexpr double kHalf = 0.5;
  return pixel.x() >= -kHalf && pixel.x() <= width - kHalf && pixel.y() >= -kHalf &&
         pixel.y() <= height - kHalf;
}

Eigen::Vector2d CameraIntrinsics::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector2d distorted = distort(point.head<2>() / point.z());
  return {fx * distorted.x() + cx, fy * distorted.y() + cy};
}

std::string laser_name(std::size_t index) {
  return fmt::format("laser_{}", index);
}

std::size_t laser_index(const std::string& name) {
  constexpr std::size_t kMost = 16;
  for (std::size_t index = 0; index < kMost; ++index)
    if (name == laser_name(index)) return index;
  throw scan_cell_common::UnusableInput("laser", "'" + name + "'",
                                        "name it laser_0, laser_1, up to " + laser_name(kMost - 1));
}

const LaserPlane& ScannerModel::laser(std::size_t index) const {
  if (!has_laser(index)) {
    refuse(laser_name(index), "not calibrated", "calibrate it, or use a laser that the model has");
  }
  return *lasers[index];
}

void check_can_scan(const ScannerModel& model) {
  for (const std::optional<LaserPlane>& laser : model.lasers)
    if (laser) return;
  refuse("lasers", "none is calibrated", "calibrate one: without its plane there are no points");
}

void check(const ScannerModel& model) {
  check(model.camera);
  if (!model.flange_to_camera.matrix().allFinite()) {
    refuse("flange_to_camera", "not finite", "calibrate the camera's place on the flange again");
  }
  for (std::size_t i = 0; i < model.lasers.size(); ++i)
    if (model.lasers[i]) check(*model.lasers[i], laser_name(i));
}

}  // namespace scan_cell_common
