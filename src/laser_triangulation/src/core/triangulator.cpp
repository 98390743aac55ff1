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

const ScannerModel& checked(const ScannerModel& model) {
  check(model);
  return model;
}

}  // namespace

Triangulator::Triangulator(const ScannerModel& model, const PeakLimits& limits)
    : model_(checked(model)), rays_(model_.camera), limits_(limits) {
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
  const bool laser_known = profile.laser < model_.lasers.size();
  const LaserPlane plane = laser_known ? model_.lasers[profile.laser] : LaserPlane();
  const Eigen::Isometry3d to_frame = flange * model_.flange_to_camera;
  ++counts_.profiles;
  for (std::size_t row = 0; row < profile.rows; ++row) {
    const double column = profile.position[row];
    if (std::isnan(column)) {
      ++counts_.rows_without_peak;
      continue;
    }
    if (!within_limits(profile, row)) continue;
    const std::size_t sensor_row = profile.first_row + row;
    if (!laser_known || !model_.camera.contains({column, static_cast<double>(sensor_row)})) {
      ++counts_.outside_sensor;
      continue;
    }
    const Eigen::Vector2d ray = rays_.ray(sensor_row, column);
    const Eigen::Vector3d direction(ray.x(), ray.y(), 1);
    const double depth = plane.distance / plane.normal.dot(direction);
    if (!(depth >= limits_.least_range && depth <= limits_.most_range)) {
      ++(std::isnan(depth) ? counts_.outside_sensor : counts_.by_range);
      continue;
    }
    const Eigen::Vector3f point = (to_frame * (depth * direction)).cast<float>();
    points.push_back({point.x(), point.y(), point.z(), profile.intensity[row],
                      static_cast<std::uint8_t>(profile.laser)});
    ++counts_.points;
  }
}

}  // namespace laser_triangulation
