// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/arm/arc_path.h"

#include <algorithm>
#include <cmath>

namespace scan_cell_sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

[[noreturn]] void refuse(const std::string& text) {
  throw ControllerRefusal(ControllerErrorCode::kNoArc, text);
}

void refuse_near(const Vector3d& side, const std::string& one, const std::string& other) {
  constexpr double kApart = 1e-3;  // [m] c4g_protocol.md
  if (side.norm() < kApart) refuse(one + " is nearer than 1 mm to " + other);
}

/// @param first, second sides of the triangle that begin at the same corner
void refuse_line(const Vector3d& first, const Vector3d& second) {
  constexpr double kBeside = 1e-4;  // [m] c4g_protocol.md
  const double longest = std::max({first.norm(), second.norm(), (second - first).norm()});
  if (first.cross(second).norm() < kBeside * longest) refuse("start, via and pose lie on a line");
}

/// The turn about one axis of the flange.
AngleAxisd turn_between(const Matrix3d& from, const Matrix3d& to, const std::string& what) {
  constexpr double kMost = 179.9 * M_PI / 180;  // [rad] c4g_protocol.md
  const AngleAxisd turn(from.transpose() * to);
  if (turn.angle() > kMost) refuse(what + " is half a turn: its direction is ambiguous");
  return turn;
}

}  // namespace

ArcPath::ArcPath(const Isometry3d& from, const Isometry3d& via, const Isometry3d& to)
    : from_(from.linear()), at_via_(via.linear()) {
  const Vector3d to_via = via.translation() - from.translation();
  const Vector3d to_end = to.translation() - from.translation();
  refuse_near(to_via, "via", "the start");
  refuse_near(to_end, "the pose", "the start");
  refuse_near(to_end - to_via, "the pose", "via");
  refuse_line(to_via, to_end);
  // the centre is equally far from all three, in their plane
  const Vector3d normal = to_via.cross(to_end).normalized();
  Matrix3d planes;
  planes << to_via.normalized().transpose(), to_end.normalized().transpose(), normal.transpose();
  const Vector3d inward =
      planes.fullPivLu().solve(Vector3d(to_via.norm() / 2, to_end.norm() / 2, 0));
  centre_ = from.translation() + inward;
  radius_ = inward.norm();
  outward_ = -inward.normalized();
  forward_ = normal.cross(outward_);
  sweep_ = angle_to(to.translation());
  via_ = angle_to(via.translation()) / sweep_;
  first_turn_ = turn_between(from_, at_via_, "the turn to via");
  second_turn_ = turn_between(at_via_, to.linear(), "the turn from via");
}

double ArcPath::angle_to(const Vector3d& place) const {
  const Vector3d offset = place - centre_;
  const double angle = std::atan2(forward_.dot(offset), outward_.dot(offset));
  return angle < 0 ? angle + 2 * M_PI : angle;
}

Isometry3d ArcPath::flange(double way) const {
  const auto part = [](const AngleAxisd& turn, double share) {
    return AngleAxisd(share * turn.angle(), turn.axis()).toRotationMatrix();
  };
  const double angle = way * sweep_;
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() =
      centre_ + radius_ * (std::cos(angle) * outward_ + std::sin(angle) * forward_);
  pose.linear() = way < via_ ? from_ * part(first_turn_, way / via_)
                             : at_via_ * part(second_turn_, (way - via_) / (1 - via_));
  return pose;
}

std::vector<FlangePath::Stretch> ArcPath::stretches() const {
  return {{via_, first_turn_.angle(), first_turn_.angle()},
          {1, second_turn_.angle(), second_turn_.angle()}};
}

}  // namespace scan_cell_sim
