// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/paths/arc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/timed_pose.h"

namespace c4g_driver {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using scan_cell_common::interpolate;
using scan_cell_common::Refused;

constexpr const char* kThreePlaces =
    "give three positions at least 1 mm apart, each at least 0.1 mm off the line through the "
    "others";

void check_apart(const Isometry3d& pose, const std::string& name, const Isometry3d& other,
                 const std::string& name_of_other) {
  constexpr double kApart = 1e-3;  // [m] c4g_protocol.md
  const double distance = (pose.translation() - other.translation()).norm();
  if (distance >= kApart) return;
  throw Refused(name, fmt::format("{:g} m from {}", distance, name_of_other), kThreePlaces);
}

/// @param first, second [m] sides of the triangle, from its corner at the start
void check_not_in_line(const Vector3d& first, const Vector3d& second) {
  constexpr double kBeside = 1e-4;  // [m] c4g_protocol.md
  const double longest = std::max({first.norm(), second.norm(), (second - first).norm()});
  const double beside = first.cross(second).norm() / longest;
  if (beside >= kBeside) return;
  throw Refused("via", fmt::format("only {:g} m off the line from start to target", beside),
                std::string(kThreePlaces) + ", or go along a line");
}

double turn_between(const Isometry3d& from, const Isometry3d& to) {
  return AngleAxisd(from.linear().transpose() * to.linear()).angle();
}

void check_turn(const Isometry3d& pose, const std::string& name, const Isometry3d& before,
                const std::string& name_of_before) {
  constexpr double kMost = 179.9 * M_PI / 180;  // [rad] c4g_protocol.md
  const double turn = turn_between(before, pose);
  if (turn <= kMost) return;
  throw Refused(
      name + " orientation", fmt::format("{:g} rad from that of {}", turn, name_of_before),
      "give one less than half a turn from it: otherwise the direction of the turn is ambiguous");
}

}  // namespace

Arc::Arc(const Isometry3d& from, const Isometry3d& via, const Isometry3d& to)
    : from_(from), via_(via), to_(to) {
  const Vector3d b = via.translation() - from.translation();
  const Vector3d c = to.translation() - from.translation();
  check_apart(via, "via", from, "where the robot stands");
  check_apart(to, "target", from, "where the robot stands");
  check_apart(via, "via", to, "the target");
  check_not_in_line(b, c);
  check_turn(via, "via", from, "the flange now");
  check_turn(to, "target", via, "via");
  // circumcentre of a triangle in space, from its corner at the start
  const Vector3d normal = b.cross(c);
  const Vector3d centre = (c.squaredNorm() * normal.cross(b) + b.squaredNorm() * c.cross(normal)) /
                          (2 * normal.squaredNorm());
  radius_ = -centre;
  axis_ = normal.normalized();
  sweep_ = angle_to(to);
  way_of_via_ = angle_to(via) / sweep_;
}

/// [rad] from the start to a pose on the circle, in the direction of the motion
double Arc::angle_to(const Isometry3d& pose) const {
  const Vector3d there = pose.translation() - from_.translation() + radius_;
  const double angle = std::atan2(axis_.dot(radius_.cross(there)), radius_.dot(there));
  return angle < 0 ? angle + 2 * M_PI : angle;
}

Isometry3d Arc::at(double way) const {
  Isometry3d pose = way < way_of_via_
                        ? interpolate(from_, via_, way / way_of_via_)
                        : interpolate(via_, to_, (way - way_of_via_) / (1 - way_of_via_));
  pose.translation() = from_.translation() + AngleAxisd(way * sweep_, axis_) * radius_ - radius_;
  return pose;
}

std::vector<Path::Stretch> Arc::stretches() const {
  const double length = sweep_ * radius_.norm();
  return {{0, way_of_via_, way_of_via_ * length, turn_between(from_, via_), "via"},
          {way_of_via_, 1, (1 - way_of_via_) * length, turn_between(via_, to_), "target"}};
}

}  // namespace c4g_driver
