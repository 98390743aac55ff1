// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/laser_line_renderer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "light/ambient_light.h"
#include "light/sensor_noise.h"
#include "scene/scramble.h"

namespace scan_cell_sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kWhiteDistance = 0.5;  // [m] of Optics::brightness
constexpr double kMaxTangent = 1;       // a fan opens +-45 degrees; chosen
constexpr double kRaysPerRow = 2;       // more are added where the surface is steep; chosen
constexpr double kJump = 0.0006;        // [m] neighbours this close are on one surface; chosen
constexpr int kDeepest = 7;             // a gap left after halving this often is a jump; chosen

}  // namespace

/// Where one ray of a fan ends.
struct LaserLineRenderer::Spot {
  double tangent = 0;
  bool lit = false;                   // the ray met a surface
  Vector3d point = Vector3d::Zero();  // in world
  bool seen = false;                  // by the camera
  Vector2d pixel = Vector2d::Zero();
  double peak = 0;  // [grey value]
};

/// One frame while being drawn.
struct LaserLineRenderer::Drawing {
  const Scene& scene;
  const Exposure& exposure;
  const Region& region;
  std::uint8_t* pixels;
  Eigen::Isometry3d world_to_camera;
  std::uint64_t seed;
  double light = 1;  // share of the exposure for which the present fan's laser is on
};

LaserLineRenderer::LaserLineRenderer(const scan_cell_common::ScannerModel& scanner,
                                     const Optics& optics)
    : scanner_(scanner),
      optics_(optics),
      noise_(std::make_shared<SensorNoise>(optics)),
      ambient_(std::make_shared<AmbientLight>(scanner.camera, optics)) {
  for (std::size_t i = 0; i < scanner_.lasers.size(); ++i) {
    const scan_cell_common::LaserPlane& laser = scanner_.laser(i);
    // The fan's middle crosses the camera's axis, or is parallel to it if the axis is in the plane.
    constexpr double kParallel = 1e-9;  // sine; chosen
    const double slope = laser.normal.z();
    const Vector3d target = std::abs(slope) > kParallel
                                ? Vector3d(Vector3d::UnitZ() * (laser.distance / slope))
                                : Vector3d(laser.origin + Vector3d::UnitZ());
    const Vector3d way = target - laser.origin;
    const Vector3d axis = (way - laser.normal.dot(way) * laser.normal).normalized();
    fans_.push_back({laser.origin, axis, laser.normal.cross(axis)});
  }
}

std::pair<double, double> LaserLineRenderer::reach(const Fan& fan, const Region& region) const {
  // Rays through the corners of the region, near and far; a margin stands in for the distortion.
  constexpr double kMargin = 1.15;                             // chosen
  constexpr std::array kDepths = {0.2, 0.35, 0.5, 0.75, 1.2};  // [m] chosen
  constexpr double kAhead = 1e-3;  // [m] not behind the projector; chosen
  double least = kMaxTangent, most = -kMaxTangent;
  for (const int row : {region.y, region.y + region.height}) {
    const double slope = (row - scanner_.camera.cy) / scanner_.camera.fy * kMargin;
    for (const double depth : kDepths) {
      const Vector3d way = Vector3d(0, slope * depth, depth) - fan.origin;
      const double tangent = way.dot(fan.across) / std::max(way.dot(fan.axis), kAhead);
      least = std::min(least, tangent);
      most = std::max(most, tangent);
    }
  }
  return {std::max(least, -kMaxTangent), std::min(most, kMaxTangent)};
}

LaserLineRenderer::Spot LaserLineRenderer::spot(const Drawing& drawing, const Fan& fan,
                                                double tangent) const {
  Spot spot;
  spot.tangent = tangent;
  const Eigen::Isometry3d& camera = drawing.exposure.camera;
  const Vector3d direction = camera.linear() * (fan.axis + tangent * fan.across).normalized();
  const auto hit = drawing.scene.first_hit(camera * fan.origin, direction);
  if (!hit) return spot;
  spot.lit = true;
  spot.point = hit->point;

  const Vector3d eye = camera.translation();
  const Vector3d in_camera = drawing.world_to_camera * hit->point;
  const bool faces_camera = hit->normal.dot(eye - hit->point) > 0;
  if (in_camera.z() <= 0 || !faces_camera || !drawing.scene.sees(hit->point, eye)) return spot;
  spot.seen = true;
  spot.pixel = scanner_.camera.project(in_camera);
  // Lambert's law, and a fan whose line grows with the distance.
  spot.peak = optics_.brightness * hit->reflectance * -hit->normal.dot(direction) *
              (kWhiteDistance / hit->distance) * (drawing.exposure.duration / optics_.exposure) *
              drawing.exposure.gain * drawing.light;
  return spot;
}

void LaserLineRenderer::connect(const Drawing& drawing, const Fan& fan, const Spot& from,
                                const Spot& to, int depth) const {
  if (!from.lit && !to.lit) return;
  const bool close = from.lit && to.lit && (from.point - to.point).norm() < kJump;
  if (close && from.seen == to.seen) {
    if (from.seen) draw(drawing, from, to);
    return;
  }
  if (depth == kDeepest) return;
  const Spot middle = spot(drawing, fan, (from.tangent + to.tangent) / 2);
  connect(drawing, fan, from, middle, depth + 1);
  connect(drawing, fan, middle, to, depth + 1);
}

void LaserLineRenderer::draw(const Drawing& drawing, const Spot& from, const Spot& to) const {
  const Spot& upper = from.pixel.y() < to.pixel.y() ? from : to;
  const Spot& lower = from.pixel.y() < to.pixel.y() ? to : from;
  const double rows = lower.pixel.y() - upper.pixel.y();
  if (!(rows > 0)) return;
  const double slope = (lower.pixel.x() - upper.pixel.x()) / rows;
  // A slanting line keeps its width across itself, so it is wider along the row.
  constexpr double kMaxWidening = 4;  // chosen
  const double sigma = optics_.stripe_sigma * std::min(std::sqrt(1 + slope * slope), kMaxWidening);
  const Region& region = drawing.region;
  const int first = std::max(static_cast<int>(std::ceil(upper.pixel.y())), region.y);
  for (int row = first; row < lower.pixel.y() && row < region.y + region.height; ++row) {
    const double below = row - upper.pixel.y();
    draw_row(drawing, row - region.y, upper.pixel.x() + slope * below - region.x, sigma,
             upper.peak + (lower.peak - upper.peak) * below / rows);
  }
}

void LaserLineRenderer::draw_row(const Drawing& drawing, int row, double column, double sigma,
                                 double peak) const {
  constexpr double kReach = 4.5;  // sigmas; chosen: a saturated line is below one grey value there
  const int begin = std::max(0, static_cast<int>(std::ceil(column - kReach * sigma)));
  const int end =
      std::min(drawing.region.width - 1, static_cast<int>(std::floor(column + kReach * sigma)));
  std::uint8_t* const pixels =
      drawing.pixels + static_cast<std::size_t>(row) * drawing.region.width;
  const float* const noise = noise_->light(drawing.seed, row);
  const auto scale = static_cast<float>(-0.5 / (sigma * sigma));
  for (int x = begin; x <= end; ++x) {
    const auto offset = static_cast<float>(x - column);
    const float light = static_cast<float>(peak) * std::exp(scale * offset * offset);
    const float shot = static_cast<float>(optics_.shot_noise) * std::sqrt(light) * noise[x];
    pixels[x] = to_grey(pixels[x] + light + shot);
  }
}

void LaserLineRenderer::render(const Scene& scene, const Exposure& exposure, const Region& region,
                               std::uint8_t* pixels) const {
  Drawing drawing{scene,
                  exposure,
                  region,
                  pixels,
                  exposure.camera.inverse(),
                  scramble(optics_.seed ^ (exposure.frame << 20U))};
  noise_->fill_dark(drawing.seed, region.width, region.height, pixels);
  ambient_->add(scene, exposure, region, *noise_, drawing.seed, pixels);
  for (std::size_t i = 0; i < fans_.size(); ++i) {
    if ((exposure.lasers >> i & 1U) == 0) continue;
    drawing.light = exposure.light.at(i);
    const auto [least, most] = reach(fans_[i], region);
    const int rays = static_cast<int>(std::ceil(kRaysPerRow * region.height)) + 1;
    Spot last = spot(drawing, fans_[i], least);
    for (int ray = 1; ray <= rays; ++ray) {
      const Spot next = spot(drawing, fans_[i], least + (most - least) * ray / rays);
      connect(drawing, fans_[i], last, next, 0);
      last = next;
    }
  }
}

}  // namespace scan_cell_sim
