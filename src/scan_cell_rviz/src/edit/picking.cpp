// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "edit/picking.h"

#include <cmath>
#include <limits>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_rviz {

using cloud_preprocess::HalfSpace;
using cloud_preprocess::PrismShape;
using Eigen::Vector3d;
using scan_cell_common::UnusableInput;

std::optional<Vector3d> picked(const cloud_preprocess::Cloud& cloud,
                               const cloud_preprocess::EditedCloud::Indices& points,
                               const Ray& ray) {
  std::optional<Vector3d> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t i : points) {
    const Vector3d off = cloud[i].getVector3fMap().cast<double>() - ray.origin;
    const double along = off.dot(ray.direction);
    if (along <= 0 || along >= least) continue;
    const double reach = ray.radius + ray.widening * along;
    if (off.squaredNorm() - along * along > reach * reach) continue;
    least = along;
    nearest = ray.origin + off;
  }
  return nearest;
}

std::optional<std::size_t> meant(const std::vector<Vector3d>& places, const Ray& ray) {
  std::optional<std::size_t> nearest;
  double least = 1;  // share of the ray's radius there
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vector3d off = places[i] - ray.origin;
    const double along = off.dot(ray.direction);
    if (along <= 0) continue;
    const double aside = (off - along * ray.direction).norm();
    const double share = aside / (ray.radius + ray.widening * along);
    if (share >= least) continue;
    least = share;
    nearest = i;
  }
  return nearest;
}

PrismShape prism_behind(const std::vector<Ray>& corners, const Vector3d& place, double depth) {
  Vector3d middle = Vector3d::Zero();
  for (const Ray& corner : corners)
    middle += corner.direction;
  PrismShape prism;
  prism.towards = -middle.normalized();
  prism.nearest = -depth;
  prism.farthest = depth;
  for (const Ray& corner : corners) {
    constexpr double kGrazing = 0.05;  // sine of three degrees; chosen
    const double slope = -corner.direction.dot(prism.towards);
    if (!(slope > kGrazing))
      throw UnusableInput("polygon", "a corner outside the view", "draw it in front of the cloud");
    const double along = (corner.origin - place).dot(prism.towards) / slope;
    prism.corners.push_back(corner.origin + along * corner.direction);
  }
  return prism;
}

HalfSpace side_towards(const std::vector<Vector3d>& places, const Vector3d& viewer) {
  constexpr double kLeast = 1e-6;  // [m^2] twice the area: 1 mm apart; chosen
  const Vector3d normal = (places.at(1) - places.at(0)).cross(places.at(2) - places.at(0));
  if (!(normal.norm() > kLeast))
    throw UnusableInput("plane", "three places on a line", "click three that span it");
  HalfSpace side;
  side.point = places[0];
  side.normal = normal.normalized();
  if (side.normal.dot(viewer - side.point) < 0) side.normal = -side.normal;
  return side;
}

}  // namespace scan_cell_rviz
