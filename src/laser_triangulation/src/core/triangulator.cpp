// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_triangulation/triangulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace laser_triangulation {
namespace {

using scan_cell_common::Also;
using scan_cell_common::ParameterTable;

constexpr float kHalfPixel = 0.5F;  // [px]

const scan_cell_common::ScannerModel& checked(const scan_cell_common::ScannerModel& model) {
  check(model);
  scan_cell_common::check_can_scan(model);
  return model;
}

const PeakLimits& checked(const PeakLimits& limits) {
  scan_cell_common::check(limits);
  return limits;
}

/// A minimum and a maximum, with their former names.
void describe_pair(ParameterTable& table, const std::string& name, double& min, double& max,
                   const ParameterTable::Range& range, const std::string& meaning) {
  table.add("min_" + name, min, range, meaning);
  table.add("max_" + name, max, range, meaning);
  table.renamed("least_" + name, "min_" + name);
  table.renamed("most_" + name, "max_" + name);
  if (min <= max) return;
  table.refuse("min_" + name, fmt::format("{:g}", min),
               fmt::format("give at most max_{}, {:g}", name, max));
}

/// Whether a peak lies on the sensor and within the limits. Free of branches, so that it
/// vectorises.
class PeakFilter {
 public:
  PeakFilter(const PeakLimits& limits, int sensor_width)
      : last_column_(static_cast<float>(sensor_width) - kHalfPixel),
        min_width_(static_cast<float>(limits.min_width)),
        max_width_(static_cast<float>(limits.max_width)),
        min_intensity_(static_cast<float>(limits.min_intensity)),
        max_intensity_(static_cast<float>(limits.max_intensity)),
        width_matters_(limits.min_width > 0 || std::isfinite(limits.max_width)),
        intensity_matters_(limits.min_intensity > 0 || std::isfinite(limits.max_intensity)) {}

  bool on_sensor(float column) const { return (column >= -kHalfPixel) & (column <= last_column_); }
  bool width_fits(float width) const {
    return !(width < min_width_) & !(width > max_width_) & !(width_matters_ & (width != width));
  }
  bool intensity_fits(float intensity) const {
    return !(intensity < min_intensity_) & !(intensity > max_intensity_) &
           !(intensity_matters_ & (intensity != intensity));
  }

 private:
  float last_column_;
  float min_width_, max_width_, min_intensity_, max_intensity_;
  bool width_matters_, intensity_matters_;  // NaN is outside limits that are set
};

/// Maps a ray to its intersection with the plane of light, in the output frame: place + (x, y, z) /
/// w, where (x, y, z, w) is linear in the ray. On the plane w = 1 / depth = normal . ray /
/// distance.
struct RayToPoint {
  RayToPoint(const scan_cell_common::LaserPlane& plane, const Eigen::Isometry3d& camera,
             const PeakLimits& limits)
      : place(camera.translation()),
        min_inverse_depth(1 / limits.max_range),
        max_inverse_depth(1 / limits.min_range) {
    linear.topRows<3>() = camera.linear();
    linear.row(3) = plane.normal.transpose() / plane.distance;
  }

  bool in_range(double inverse_depth) const {
    return (inverse_depth >= min_inverse_depth) & (inverse_depth <= max_inverse_depth);
  }

  Eigen::Matrix<double, 4, 3> linear;
  Eigen::Vector3d place;
  double min_inverse_depth;  // [1/m]
  double max_inverse_depth;
};

void count_rejected(const PeakFilter& filter, const ProfileView& profile, std::size_t row,
                    PeakCounts& counts) {
  if (std::isnan(profile.position[row])) {
    ++counts.rows_without_peak;
  } else if (!filter.width_fits(profile.width[row])) {
    ++counts.by_width;
  } else if (!filter.intensity_fits(profile.intensity[row])) {
    ++counts.by_intensity;
  } else {
    ++counts.outside_sensor;
  }
}

/// Rows processed together, one field after the other: the compiler vectorises such loops.
struct Block {
  static constexpr std::size_t kRows = RayTable::kMaxRows;

  std::size_t count = 0;
  bool fits[kRows];
  float column[kRows];  // 0 if the peak does not fit
  Eigen::Vector2d ray[kRows];
  double inverse_depth[kRows];
  float x[kRows], y[kRows], z[kRows];

  void select(const PeakFilter& peak_filter, const ProfileView& profile, std::size_t first) {
    const PeakFilter filter = peak_filter;
    const float* const position = profile.position + first;
    const float* const width = profile.width + first;
    const float* const intensity = profile.intensity + first;
    for (std::size_t i = 0; i < count; ++i) {
      fits[i] = filter.on_sensor(position[i]) & filter.width_fits(width[i]) &
                filter.intensity_fits(intensity[i]);
    }
    for (std::size_t i = 0; i < count; ++i)
      column[i] = fits[i] ? position[i] : 0;
  }

  void meet(const RayToPoint& to_point) {
    const Eigen::Matrix<double, 4, 3> m = to_point.linear;
    const Eigen::Vector3d place = to_point.place;
    for (std::size_t i = 0; i < count; ++i) {
      const double u = ray[i].x();
      const double v = ray[i].y();
      const double inverse = m(3, 0) * u + m(3, 1) * v + m(3, 2);
      const double depth = 1 / inverse;
      inverse_depth[i] = inverse;
      x[i] = static_cast<float>(place.x() + depth * (m(0, 0) * u + m(0, 1) * v + m(0, 2)));
      y[i] = static_cast<float>(place.y() + depth * (m(1, 0) * u + m(1, 1) * v + m(1, 2)));
      z[i] = static_cast<float>(place.z() + depth * (m(2, 0) * u + m(2, 1) * v + m(2, 2)));
    }
  }

  /// @return one past the last point written
  ScanPoint* keep(const PeakFilter& filter, const RayToPoint& to_point, const ProfileView& profile,
                  std::size_t first, PeakCounts& counts, ScanPoint* point) const {
    const auto laser = static_cast<std::uint8_t>(profile.laser);
    const Eigen::Vector3f from = to_point.place.cast<float>();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t row = first + i;
      if (fits[i] & to_point.in_range(inverse_depth[i])) {
        *point++ = {x[i],     y[i],         z[i],    profile.intensity[row],
                    laser,    profile.pass, {0, 0},  profile.width[row],
                    from.x(), from.y(),     from.z()};
      } else if (!fits[i]) {
        count_rejected(filter, profile, row, counts);
      } else {
        ++(std::isnan(inverse_depth[i]) ? counts.outside_sensor : counts.by_range);
      }
    }
    return point;
  }
};

}  // namespace

void describe(ParameterTable& table, PeakLimits& limits) {
  describe_pair(table, "width", limits.min_width, limits.max_width, {0, 1e4, "px", Also::kNone},
                "of the stripe");
  describe_pair(table, "intensity", limits.min_intensity, limits.max_intensity,
                {0, 65535, "grey value", Also::kNone}, "height of the peak");
  describe_pair(table, "range", limits.min_range, limits.max_range, {0.001, 100, "m"},
                "along the camera's axis");
}

Triangulator::Triangulator(const scan_cell_common::ScannerModel& model, const PeakLimits& limits)
    : model_(checked(model)), rays_(model_.camera), limits_(checked(limits)) {}

void Triangulator::add(const ProfileView& profile, const Eigen::Isometry3d& flange,
                       std::vector<ScanPoint>& points) {
  ++counts_.profiles;
  const bool laser_known = model_.has_laser(profile.laser);
  const auto height = static_cast<std::size_t>(model_.camera.height);
  const std::size_t below = laser_known && profile.first_row < height ? profile.first_row : height;
  const std::size_t on_sensor = std::min(profile.rows, height - below);
  const RayToPoint to_point(
      laser_known ? model_.laser(profile.laser) : scan_cell_common::LaserPlane(),
      flange * model_.flange_to_camera, limits_);
  const PeakFilter filter(limits_, model_.camera.width);
  profile_.resize(std::max(profile_.size(), profile.rows));
  ScanPoint* end = profile_.data();
  Block block;
  for (std::size_t first = 0; first < on_sensor; first += block.count) {
    block.count = std::min(Block::kRows, on_sensor - first);
    block.select(filter, profile, first);
    rays_.find(profile.first_row + first, block.column, block.count, block.ray);
    block.meet(to_point);
    end = block.keep(filter, to_point, profile, first, counts_, end);
  }
  for (std::size_t row = on_sensor; row < profile.rows; ++row)
    count_rejected(filter, profile, row, counts_);
  counts_.points += static_cast<std::size_t>(end - profile_.data());
  points.insert(points.end(), profile_.data(), end);
}

}  // namespace laser_triangulation
