// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_triangulation/triangulator.h"

#include <cmath>

#include "scan_cell_common/errors.h"

namespace laser_triangulation {
namespace {

void check_order(const char* name, double least, double most) {
  if (least <= most) return;
  throw scan_cell_common::InvalidParameter(
      std::string("least_") + name, std::to_string(least) + ", above most_" + name,
      "give a least that is not above " + std::to_string(most));
}

/// True too where the value is not known and nothing is asked of it.
bool within(float value, double least, double most) {
  return (value >= least && value <= most) || (std::isnan(value) && least <= 0 && std::isinf(most));
}

}  // namespace

Triangulator::Triangulator(const ScannerModel& model, const PeakLimits& limits)
    : model_(model), limits_(limits) {
  check(model_);
  check_order("width", limits.least_width, limits.most_width);
  check_order("intensity", limits.least_intensity, limits.most_intensity);
  check_order("range", limits.least_range, limits.most_range);
}

bool Triangulator::within_limits(const ProfileView& profile, std::size_t row) {
  if (!within(profile.width[row], limits_.least_width, limits_.most_width)) {
    ++counts_.by_width;
    return false;
  }
  if (!within(profile.intensity[row], limits_.least_intensity, limits_.most_intensity)) {
    ++counts_.by_intensity;
    return false;
  }
  return true;
}

void Triangulator::add(const ProfileView& profile, const Eigen::Isometry3d& flange,
                       std::vector<ScanPoint>& points) {
  const CameraIntrinsics& camera = model_.camera;
  const bool laser_known = profile.laser < model_.lasers.size();
  const LaserPlane plane = laser_known ? model_.lasers[profile.laser] : LaserPlane();
  const Eigen::Isometry3d to_frame = flange * model_.flange_to_camera;
  ++counts_.profiles;
  // Neighbouring rows have neighbouring rays, so the last one is a good start for the next.
  Eigen::Vector2d distorted = Eigen::Vector2d::Zero();
  Eigen::Vector2d ray = Eigen::Vector2d::Zero();
  for (std::size_t row = 0; row < profile.rows; ++row) {
    const Eigen::Vector2d pixel(profile.position[row],
                                profile.first_row + static_cast<double>(row));
    if (std::isnan(pixel.x())) {
      ++counts_.rows_without_peak;
      continue;
    }
    if (!within_limits(profile, row)) continue;
    const Eigen::Vector2d next((pixel.x() - camera.cx) / camera.fx,
                               (pixel.y() - camera.cy) / camera.fy);
    const Eigen::Vector2d guess = ray + (next - distorted);
    Eigen::Vector2d undistorted = guess;
    if (!laser_known || !camera.contains(pixel) || !camera.undistort(next, undistorted)) {
      ++counts_.outside_sensor;
      continue;
    }
    distorted = next;
    ray = undistorted;
    const Eigen::Vector3d direction(ray.x(), ray.y(), 1);
    const double depth = plane.distance / plane.normal.dot(direction);
    if (!(depth >= limits_.least_range && depth <= limits_.most_range)) {
      ++counts_.by_range;
      continue;
    }
    const Eigen::Vector3f point = (to_frame * (depth * direction)).cast<float>();
    points.push_back({point.x(), point.y(), point.z(), profile.intensity[row],
                      static_cast<std::uint8_t>(profile.laser)});
    ++counts_.points;
  }
}

}  // namespace laser_triangulation
