// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_planner/sight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"
#include "scan_cell_common/pose/timed_pose.h"

namespace pass_planner {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using scan_cell_common::LaserPlane;

constexpr double kBorder = 10;  // [px] 4.5 sigma of a line of 2.2 px: one that is cut is no peak

double angle_between(const Vector3d& normal, const Vector3d& way) {
  return std::acos(std::min(1.0, std::abs(normal.dot(way.normalized()))));
}

/// A laser's plane of light in the frame of the flange's poses.
struct Light {
  Light(const LaserPlane& laser, const Isometry3d& camera)
      : normal(camera.linear() * laser.normal),
        distance(laser.distance + normal.dot(camera.translation())) {}

  /// [m] from the plane to a point, with sign.
  double off(const Vector3d& point) const { return normal.dot(point) - distance; }

  Vector3d normal;
  double distance;
};

}  // namespace

void describe(scan_cell_common::ParameterTable& table, SightParameters& parameters) {
  const scan_cell_common::ParameterTable::Range angle = {0.1, 1.57, "rad"};
  const scan_cell_common::ParameterTable::Range range = {0.001, 100, "m"};
  const scan_cell_common::ParameterTable::Range pixels = {0, 1e5, "px"};
  table.add("max_light_angle", parameters.max_light_angle, angle,
            "between the surface's normal and the laser's light");
  table.add("max_sight_angle", parameters.max_sight_angle, angle,
            "between the surface's normal and the camera's sight");
  table.add("min_range", parameters.min_range, range,
            "along the camera's axis, as in `laser_triangulation`");
  table.add("max_range", parameters.max_range, range, "along the camera's axis");
  table.add("region_x", parameters.region_x, pixels,
            "first column of the image, as in the camera's node");
  table.add("region_y", parameters.region_y, pixels, "first row of the image");
  table.add("region_width", parameters.region_width, pixels, "0: to the sensor's right edge");
  table.add("region_height", parameters.region_height, pixels, "0: to the sensor's bottom edge");
  if (parameters.min_range < parameters.max_range) return;
  table.refuse("min_range", fmt::format("{:g}", parameters.min_range),
               fmt::format("give less than max_range, {:g}", parameters.max_range));
}

std::string to_string(Sight sight) {
  const char* const names[] = {"out_of_range", "shadowed", "grazing", "seen"};
  return names[static_cast<std::size_t>(sight)];
}

std::string to_string(Fault fault) {
  const char* const names[] = {"none", "not_passed", "depth", "image", "light", "sight"};
  return names[static_cast<std::size_t>(fault)];
}

bool is_better(const Sighting& a, const Sighting& b) {
  if (a.sight != b.sight) return a.sight > b.sight;
  if (a.sight == Sight::kOutOfRange) return a.fault > b.fault;
  return std::max(a.light_angle, a.sight_angle) < std::max(b.light_angle, b.sight_angle);
}

SightCheck::SightCheck(const scan_cell_common::ScannerModel& scanner, const Surface& surface,
                       const SightParameters& parameters)
    : scanner_(scanner), surface_(surface), parameters_(parameters) {
  scan_cell_common::check(parameters_);
  const auto pixels = [](int count) { return static_cast<std::uint32_t>(count); };
  window_ = window_of({pixels(parameters.region_x), pixels(parameters.region_y),
                       pixels(parameters.region_width), pixels(parameters.region_height)},
                      "region");
}

SightCheck::Window SightCheck::window_of(const scan_cell::CameraRegion& region,
                                         const std::string& name) const {
  const auto range = [&name](const char* axis, double first, double count, double sensor) {
    const double end = count == 0 ? sensor : first + count;
    if (end <= sensor && end - first > 2 * kBorder) return Vector2d(first, end - 1);
    throw scan_cell_common::InvalidParameter(
        fmt::format("{}_{}", name, axis), fmt::format("{:g} .. {:g} px", first, end - 1),
        fmt::format("give the camera's region, within the sensor's {:g} px", sensor));
  };
  const Vector2d columns = range("x", region.x, region.width, scanner_.camera.width);
  const Vector2d rows = range("y", region.y, region.height, scanner_.camera.height);
  return {{columns[0] + kBorder, rows[0]}, {columns[1] - kBorder, rows[1]}};
}

/// Why a point is not in the image; kNone if it is.
Fault SightCheck::outside(const Vector3d& in_camera, const Window& window) const {
  constexpr double kSameRay = 1e-6;  // beyond some angle the lens's model folds over; chosen
  if (in_camera.z() < parameters_.min_range || in_camera.z() > parameters_.max_range)
    return Fault::kDepth;
  const Vector2d ray = in_camera.head<2>() / in_camera.z();
  Vector2d back = scanner_.camera.distort(ray);
  const Vector2d pixel = scanner_.camera.project(in_camera);
  const bool in_region =
      (pixel.array() >= window.least.array()).all() && (pixel.array() <= window.most.array()).all();
  const bool one_ray = scanner_.camera.undistort(Vector2d(back), back) &&
                       (back - ray).norm() < kSameRay * (1 + ray.norm());
  return in_region && one_ray ? Fault::kNone : Fault::kImage;
}

/// The sighting from the camera pose at which the laser's plane passes over the place.
Sighting SightCheck::from(const Isometry3d& camera, const LaserPlane& laser,
                          const Surface::Place& place, const Window& window) const {
  Sighting sighting;
  sighting.fault = outside(camera.inverse() * place.point, window);
  if (sighting.fault != Fault::kNone) return sighting;
  const Vector3d eye = camera.translation();
  const Vector3d light = camera * laser.origin;
  sighting.light_angle = angle_between(place.normal, light - place.point);
  sighting.sight_angle = angle_between(place.normal, eye - place.point);
  sighting.sight = Sight::kShadowed;
  sighting.fault = Fault::kLight;
  sighting.obstacle = surface_.obstacle(place.point, light);
  if (sighting.obstacle) return sighting;
  sighting.fault = Fault::kSight;
  sighting.obstacle = surface_.obstacle(place.point, eye);
  const bool same_side =
      place.normal.dot(light - place.point) * place.normal.dot(eye - place.point) > 0;
  if (!sighting.obstacle && !same_side) sighting.obstacle = place.point;
  if (sighting.obstacle) return sighting;
  sighting.sight = Sight::kGrazing;
  sighting.fault = Fault::kLight;
  if (sighting.light_angle > parameters_.max_light_angle) return sighting;
  sighting.fault = Fault::kSight;
  if (sighting.sight_angle > parameters_.max_sight_angle) return sighting;
  sighting.sight = Sight::kSeen;
  sighting.fault = Fault::kNone;
  return sighting;
}

std::vector<Sighting> SightCheck::along(const Sweep& sweep,
                                        const std::vector<Surface::Place>& places) const {
  const LaserPlane& laser = scanner_.laser(sweep.laser);
  const Window window =
      sweep.region ? window_of(*sweep.region, fmt::format("pass {}: region", sweep.pass + 1))
                   : window_;
  std::vector<Light> lights;
  for (const Isometry3d& flange : sweep.flange)
    lights.emplace_back(laser, flange * scanner_.flange_to_camera);
  std::vector<Sighting> sightings(places.size());
  for (std::size_t p = 0; p < places.size(); ++p) {
    double before = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const double now = lights[i].off(places[p].point);
      if (i > 0 && (before < 0) != (now < 0)) {
        const Isometry3d flange = scan_cell_common::interpolate(
            sweep.flange[i - 1], sweep.flange[i], before / (before - now));
        const Sighting found = from(flange * scanner_.flange_to_camera, laser, places[p], window);
        if (is_better(found, sightings[p])) sightings[p] = found;
      }
      before = now;
    }
  }
  return sightings;
}

std::size_t PathSight::count(Sight sight) const {
  return static_cast<std::size_t>(
      std::count_if(best.begin(), best.end(),
                    [sight](const Sighting& sighting) { return sighting.sight == sight; }));
}

std::vector<std::size_t> PathSight::not_seen() const {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < best.size(); ++i) {
    if (best[i].sight != Sight::kSeen) places.push_back(i);
  }
  return places;
}

PathSight look_along(const SightCheck& check, std::vector<Sweep> sweeps,
                     const std::vector<Surface::Place>& places) {
  PathSight result;
  result.best.resize(places.size());
  for (std::size_t s = 0; s < sweeps.size(); ++s) {
    result.of_sweeps.push_back(check.along(sweeps[s], places));
    for (std::size_t i = 0; i < places.size(); ++i) {
      Sighting& sighting = result.of_sweeps.back()[i];
      sighting.sweep = s;
      if (s == 0 || is_better(sighting, result.best[i])) result.best[i] = sighting;
    }
  }
  result.sweeps = std::move(sweeps);
  return result;
}

}  // namespace pass_planner
