// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/scanner/line_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scanner_views {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// One line of one laser.
struct LineScanner::Exposure {
  Eigen::Isometry3d camera;  // in world
  Vector3d source;           // [m] of the light, in the camera's frame
  Vector3d axis;             // of the fan, in the camera's frame
  Vector3d normal;           // of the sheet
  std::uint8_t laser = 0;
  std::uint8_t pass = 0;
};

/// A part of the spot lit by a ray of the fan, as the camera sees it.
struct LineScanner::Spot {
  double light = 0;                   // light from it; 0: not lit, or not seen
  Vector2d image = Vector2d::Zero();  // [px] from the camera's axis
  unsigned surface = 0;
};

LineScanner::Spot LineScanner::spot(const Exposure& exposure, double tangent, double offset) const {
  Spot spot;
  const Eigen::Matrix3d& turn = exposure.camera.linear();
  const Vector3d way = turn * (exposure.axis + tangent * Vector3d::UnitY()).normalized();
  const Vector3d source = exposure.camera * (exposure.source + offset * exposure.normal);
  const auto hit = scene_.first_hit(source, way);
  if (!hit) return spot;
  const Vector3d eye = exposure.camera.translation();
  const bool faces_camera = hit->normal.dot(eye - hit->point) > 0;
  if (!faces_camera || !scene_.sees(hit->point, eye)) return spot;
  const Vector3d in_camera = exposure.camera.inverse() * hit->point;
  spot.light = -hit->normal.dot(way);  // Lambert's law
  spot.image = scanner_.focal_length * in_camera.head<2>() / in_camera.z();
  spot.surface = hit->surface;
  return spot;
}

void LineScanner::measure(const Exposure& exposure, double tangent, Draws& draws,
                          ScanPoints& points) const {
  // Samples across the sheet at its middle and 1.2 sigmas beside it, and along the line over the
  // spacing of its points, with the weights of a normal distribution.
  constexpr double kBeside = 1.2;
  constexpr double kLess = 0.487;  // exp(-1.2^2 / 2)
  const double along =
      0.5 * scanner_.point_spacing / std::hypot(scanner_.stand_off, scanner_.baseline);
  const double across = kBeside * scanner_.stripe_sigma;
  const std::array<std::array<double, 3>, 5> parts = {
      {{0, 0, 1}, {0, across, kLess}, {0, -across, kLess}, {along, 0, kLess}, {-along, 0, kLess}}};
  std::array<Spot, 5> spots;
  double whole = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& [aside, offset, weight] = parts[i];
    spots[i] = spot(exposure, tangent + aside, offset);
    spots[i].light *= weight * std::max(0.0, 1 + scanner_.speckle * draws.normal());
    whole += weight;
  }
  const Spot& brightest = *std::max_element(
      spots.begin(), spots.end(), [](const Spot& a, const Spot& b) { return a.light < b.light; });
  Vector2d centre = Vector2d::Zero();
  double light = 0;
  for (const Spot& each : spots) {
    if (std::abs(each.image.x() - brightest.image.x()) > scanner_.window) continue;
    centre += each.light * each.image;
    light += each.light;
  }
  if (light / whole < scanner_.least_light) return;
  centre /= light;
  centre.x() += scanner_.peak_noise / std::sqrt(std::min(1.0, light / whole)) * draws.normal();
  // Intersection of the camera's ray with the sheet.
  const Vector3d ray(centre.x() / scanner_.focal_length, centre.y() / scanner_.focal_length, 1);
  const double depth = exposure.normal.dot(exposure.source) / exposure.normal.dot(ray);
  points.places.emplace_back(exposure.camera * (depth * ray));
  points.seen_from.emplace_back(exposure.camera.translation());
  points.lasers.push_back(exposure.laser);
  points.passes.push_back(exposure.pass);
  points.surfaces.push_back(brightest.surface);
}

/// The part of a sweep that one laser lights, as wide as its fan.
struct LineScanner::Strip {
  Eigen::Matrix3d head;
  Vector3d least;     // [m] x and y in the head's axes; z of the camera
  double length = 0;  // [m] along x
  double middle = 0;  // [m] of the strip along y, from `least`
  double widest = 0;  // tangent of the fan's half angle
  std::uint8_t laser = 0;
  std::uint8_t pass = 0;
};

void LineScanner::follow(const Strip& strip, Draws& draws, ScanPoints& points) const {
  const double to_focus = std::hypot(scanner_.stand_off, scanner_.baseline);
  const double step = scanner_.point_spacing / to_focus;
  const int rays = static_cast<int>(strip.widest / step);
  Exposure exposure;
  exposure.laser = strip.laser;
  exposure.pass = strip.pass;
  exposure.source = {strip.laser == 0 ? -scanner_.baseline : scanner_.baseline, 0, 0};
  exposure.axis = (Vector3d(0, 0, scanner_.stand_off) - exposure.source).normalized();
  exposure.normal = exposure.axis.cross(Vector3d::UnitY());
  exposure.camera.linear() = strip.head;
  for (double x = 0; x <= strip.length; x += scanner_.line_spacing) {
    exposure.camera.translation() = strip.head * (strip.least + Vector3d(x, strip.middle, 0));
    for (int ray = -rays; ray <= rays; ++ray)
      measure(exposure, ray * step, draws, points);
  }
}

void LineScanner::scan(const Sweep& sweep, Draws& draws, ScanPoints& points) const {
  constexpr double kWidest = 0.4;   // [m] of a strip: 20 degrees to each side of the fan; chosen
  constexpr double kMargin = 0.01;  // [m] around the scanned region; chosen
  const Vector3d size = sweep.extent.sizes() + 2 * Vector3d::Constant(kMargin);
  // Above and below the stand-off, the sheet is in front of or behind the camera.
  const double aside = size.z() / 2 * scanner_.baseline / scanner_.stand_off;
  const double strips = std::ceil(size.y() / kWidest);
  Strip strip;
  strip.head = sweep.head;
  strip.least = {sweep.extent.min().x() - kMargin - aside, sweep.extent.min().y() - kMargin,
                 sweep.extent.center().z() - scanner_.stand_off};
  strip.length = size.x() + 2 * aside;
  strip.widest = (size.y() / strips / 2 + kMargin) / (scanner_.stand_off - size.z() / 2);
  strip.pass = sweep.number;
  for (int i = 0; i < strips; ++i) {
    strip.middle = (i + 0.5) * size.y() / strips;
    for (std::uint8_t laser = 0; laser <= (sweep.second_laser ? 1 : 0); ++laser) {
      strip.laser = laser;
      follow(strip, draws, points);
    }
  }
}

}  // namespace scanner_views
