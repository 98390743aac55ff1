// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rewrite/circle.h"

#include <algorithm>
#include <cmath>

namespace tool_path_programs {
namespace {

constexpr double kLeastHeight = 1e-6;  // [m] of the triangle: below it noise determines the circle

}  // namespace

std::optional<Circle> Circle::through(const Eigen::Vector3d& from, const Eigen::Vector3d& via,
                                      const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = via - from;
  const Eigen::Vector3d b = to - from;
  const Eigen::Vector3d normal = a.cross(b);
  const double longest = std::max({a.norm(), b.norm(), (to - via).norm()});
  if (!(normal.norm() > kLeastHeight * longest)) return std::nullopt;
  Circle circle;
  circle.centre_ = from + (b.squaredNorm() * normal.cross(a) + a.squaredNorm() * b.cross(normal)) /
                              (2 * normal.squaredNorm());
  circle.radius_ = from - circle.centre_;
  circle.axis_ = normal.normalized();
  circle.via_ = circle.angle_to(via);
  circle.sweep_ = circle.angle_to(to);
  return circle;
}

double Circle::angle_to(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d arm = point - centre_;
  const double angle = std::atan2(axis_.dot(radius_.cross(arm)), radius_.dot(arm));
  return angle < 0 ? angle + 2 * M_PI : angle;
}

double Circle::distance(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d arm = point - centre_;
  const double height = axis_.dot(arm);
  return std::hypot((arm - height * axis_).norm() - radius_.norm(), height);
}

std::vector<ArcPlace> Circle::places(double step) const {
  std::vector<ArcPlace> places;
  const auto add = [&](double begin, double end) {
    const int count = static_cast<int>(std::ceil((end - begin) * radius() / step));
    for (int i = 1; i < count; ++i) {
      const double angle = begin + (end - begin) * i / count;
      places.push_back({centre_ + Eigen::AngleAxisd(angle, axis_) * radius_, angle});
    }
  };
  add(0, via_);
  add(via_, sweep_);
  return places;
}

}  // namespace tool_path_programs
