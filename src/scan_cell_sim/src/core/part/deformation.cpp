// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/deformation.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_sim {
namespace {

using Eigen::Vector3d;

/// Beyond this many radii a hump counts as flat: exp(-5^2 / 2) = 4e-6.
constexpr double kReach = 5;  // radii; chosen

/// Displacement of material along `towards`, and its derivative.
struct Shift {
  double amount;
  Vector3d gradient;
};

/// height * exp(-|offset|^2 / (2 radius^2)), where `offset` moves with the point.
Shift gaussian(double height, double radius, const Vector3d& offset) {
  const double amount = height * std::exp(-offset.squaredNorm() / (2 * radius * radius));
  return {amount, -amount / (radius * radius) * offset};
}

Vector3d offset_of(const Bulge& bulge, const Vector3d& point) {
  const Vector3d offset = point - bulge.centre;
  return offset - bulge.towards.dot(offset) * bulge.towards;
}

/// Offset of a point from the nearest point of the filed line.
Vector3d offset_of(const FiledEdge& edge, const Vector3d& point) {
  const Vector3d line = edge.to - edge.from;
  const double along = (point - edge.from).dot(line) / line.squaredNorm();
  return point - (edge.from + std::clamp(along, 0.0, 1.0) * line);
}

Shift shift(const Bulge& bulge, const Vector3d& point) {
  return gaussian(bulge.height, bulge.radius, offset_of(bulge, point));
}

Shift shift(const FiledEdge& edge, const Vector3d& point) {
  return gaussian(edge.depth, edge.radius, offset_of(edge, point));
}

Shift shift(const Bend& bend, const Vector3d& point) {
  const double along = bend.along.dot(point);
  return {bend.curvature / 2 * along * along, bend.curvature * along * bend.along};
}

double bound(double height, double radius, const Vector3d& offset) {
  return offset.norm() > kReach * radius ? 0 : std::abs(height) / (radius * radius);
}

double bound(const Bulge& bulge, const Vector3d& point) {
  return bound(bulge.height, bulge.radius, offset_of(bulge, point));
}

double bound(const FiledEdge& edge, const Vector3d& point) {
  return bound(edge.depth, edge.radius, offset_of(edge, point));
}

double bound(const Bend& bend, const Vector3d&) {
  return std::abs(bend.curvature);
}

}  // namespace

Vector3d Deformation::apply(const Vector3d& point) const {
  Vector3d moved = point;
  for (const Term& term : terms_) {
    std::visit([&](const auto& t) { moved += shift(t, point).amount * t.towards; }, term);
  }
  return moved;
}

Eigen::Matrix3d Deformation::jacobian(const Vector3d& point) const {
  Eigen::Matrix3d result = Eigen::Matrix3d::Identity();
  for (const Term& term : terms_) {
    std::visit([&](const auto& t) { result += t.towards * shift(t, point).gradient.transpose(); },
               term);
  }
  return result;
}

Vector3d Deformation::invert(const Vector3d& deformed) const {
  constexpr int kMaxSteps = 50;         // chosen
  constexpr double kTolerance = 1e-12;  // [m] chosen
  Vector3d point = deformed;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Vector3d error = apply(point) - deformed;
    if (error.norm() < kTolerance) return point;
    point -= jacobian(point).partialPivLu().solve(error);
  }
  throw scan_cell_common::UnusableInput("deformation",
                                        fmt::format("({:g} {:g} {:g}) m is not a point of the "
                                                    "deformed part",
                                                    deformed.x(), deformed.y(), deformed.z()),
                                        "deform less, or give a point near the part");
}

double Deformation::curvature_bound(const Vector3d& point) const {
  double sum = 0;
  for (const Term& term : terms_) {
    sum += std::visit([&](const auto& t) { return bound(t, point); }, term);
  }
  return sum;
}

}  // namespace scan_cell_sim
