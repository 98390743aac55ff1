// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parts/deformation.h"

#include <cmath>

namespace cases {

Deformation none() {
  return [](const Eigen::Vector3d& p) { return p; };
}

Deformation both(Deformation first, Deformation second) {
  return [first, second](const Eigen::Vector3d& p) { return second(first(p)); };
}

Deformation bend(double rise, double width) {
  const double half = width / 2;
  const double radius = (half * half + rise * rise) / (2 * rise);
  return [radius](const Eigen::Vector3d& p) {
    const double angle = p.x() / radius;
    return Eigen::Vector3d((radius + p.z()) * std::sin(angle), p.y(),
                           (radius + p.z()) * std::cos(angle) - radius);
  };
}

Deformation twist(double angle, double width) {
  return [=](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(Eigen::AngleAxisd(angle * p.x() / width, Eigen::Vector3d::UnitX()) * p);
  };
}

Deformation bulge(double rise, double radius, const Eigen::Vector2d& at) {
  return [=](const Eigen::Vector3d& p) {
    const double away = (p.head<2>() - at).norm() / radius;
    return Eigen::Vector3d(p.x(), p.y(), p.z() + rise * std::exp(-away * away));
  };
}

Deformation bulge_at(const Eigen::Vector3d& at, const Eigen::Vector3d& rise, double radius) {
  return [=](const Eigen::Vector3d& p) {
    const double away = (p - at).norm() / radius;
    return Eigen::Vector3d(p + std::exp(-away * away) * rise);
  };
}

Deformation swelling(double most, double width) {
  return [=](const Eigen::Vector3d& p) {
    const double x = p.x() / width;
    const double y = p.y() / width;
    return Eigen::Vector3d(p.x() + most * std::sin(2.5 * x + 2 * y), p.y() + most * std::sin(3 * x),
                           p.z());
  };
}

Deformation filed(const Eigen::Vector3d& normal, double distance) {
  const Eigen::Vector3d unit = normal.normalized();
  return [=](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p - std::max(0.0, unit.dot(p) - distance) * unit);
  };
}

Eigen::Isometry3d deformed(const Deformation& deformation, const Eigen::Isometry3d& pose) {
  constexpr double kStep = 1e-6;
  const Eigen::Vector3d at = pose.translation();
  const auto along = [&](const Eigen::Vector3d& way) -> Eigen::Vector3d {
    return (deformation(at + kStep * way) - deformation(at - kStep * way)) / (2 * kStep);
  };
  const Eigen::Vector3d x = along(pose.linear().col(0));
  const Eigen::Vector3d y = along(pose.linear().col(1));
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() = deformation(at);
  Eigen::Matrix3d frame;
  frame.col(2) = x.cross(y).normalized();
  frame.col(0) = x.normalized();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  result.linear() = frame;
  return result;
}

}  // namespace cases
