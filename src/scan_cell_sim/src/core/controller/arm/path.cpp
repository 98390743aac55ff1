// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "controller/arm/wire_pose.h"
#include "scan_cell_common/pose/timed_pose.h"

namespace scan_cell_sim {
namespace {

constexpr double kNothing = 1e-12;  // [rad], [m] or steps: no division by less; chosen

class JointPath : public Path {
 public:
  JointPath(const Joints& from, const Joints& to) : from_(from), to_(to) {}
  Joints joints(double way) const override { return from_ + way * (to_ - from_); }
  Eigen::Isometry3d flange(double way) const override { return flange_of(joints(way)); }

 private:
  Joints from_;
  Joints to_;
};

double nearest_turn(double from, double to) {
  return from + std::remainder(to - from, 360.0);
}

class LinePath : public Path {
 public:
  LinePath(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, bool euler)
      : from_(from), to_(to), euler_(euler), wire_from_(to_wire(from)), wire_to_(to_wire(to)) {
    for (int i = 3; i < 6; ++i)
      wire_to_[i] = nearest_turn(wire_from_[i], wire_to_[i]);
  }

  Eigen::Isometry3d flange(double way) const override {
    if (!euler_) return scan_cell_common::interpolate(from_, to_, way);
    WireSix wire{};
    for (int i = 0; i < 6; ++i)
      wire[i] = wire_from_[i] + way * (wire_to_[i] - wire_from_[i]);
    return pose_from_wire(wire);
  }

  Joints joints(double way) const override {
    const double knot = std::clamp(way, 0.0, 1.0) * static_cast<double>(knots_.size() - 1);
    const auto before = std::min(static_cast<std::size_t>(knot), knots_.size() - 2);
    const double fraction = knot - static_cast<double>(before);
    const Joints guess = (1 - fraction) * knots_[before] + fraction * knots_[before + 1];
    return joints_of(flange(way), guess).value_or(guess);
  }

  double length() const { return (to_.translation() - from_.translation()).norm(); }

  /// [rad] to which the rotational speed refers: the turn about the one axis, or the largest of A,
  /// E and R
  double angle() const { return euler_ ? changes().maxCoeff() : turn(); }

  /// Follows the line from knot to knot.
  /// @return [1/s] the most that the axes allow
  double follow(const Joints& from);

 private:
  double turn() const {
    return Eigen::AngleAxisd(from_.linear().transpose() * to_.linear()).angle();
  }

  /// [rad] of A, E, R
  Eigen::Vector3d changes() const {
    const Eigen::Vector3d degrees(wire_to_[3] - wire_from_[3], wire_to_[4] - wire_from_[4],
                                  wire_to_[5] - wire_from_[5]);
    return degrees.cwiseAbs() * M_PI / 180;
  }

  Eigen::Isometry3d from_;
  Eigen::Isometry3d to_;
  bool euler_;
  WireSix wire_from_;
  WireSix wire_to_;
  std::vector<Joints> knots_;
};

/// Whether the arm is in a singular posture, or has passed one since `before`.
bool singular(const Joints& before, const Joints& joints) {
  constexpr double kAngle = 0.5 * M_PI / 180;  // [rad] c4g_protocol.md
  constexpr double kDistance = 0.005;          // [m] c4g_protocol.md
  const SingularPostures was = distance_to_singular(before);
  const SingularPostures is = distance_to_singular(joints);
  const auto met = [](double then, double now, double least) {
    return std::abs(now) < least || (then < 0) != (now < 0);
  };
  return met(was.wrist, is.wrist, kAngle) || met(was.elbow, is.elbow, kAngle) ||
         met(was.shoulder, is.shoulder, kDistance);
}

void refuse_singular(const Joints& before, const Joints& joints) {
  constexpr double kMaxTurn = 0.35;  // [rad] from knot to knot; more turns the wrist over; chosen
  if (singular(before, joints)) {
    throw ControllerRefusal(ControllerErrorCode::kSingular, "the line passes a singular posture");
  }
  if ((joints - before).cwiseAbs().maxCoeff() > kMaxTurn) {
    throw ControllerRefusal(ControllerErrorCode::kSingular, "the line turns the wrist over");
  }
}

double LinePath::follow(const Joints& from) {
  constexpr double kKnotLength = 0.01;  // [m] chosen
  constexpr double kKnotAngle = 0.035;  // [rad] chosen
  const double turned = euler_ ? changes().sum() : turn();
  const double steps =
      std::ceil(std::max({1.0, length() / kKnotLength, turned / kKnotAngle}) - kNothing);
  double max_speed = std::numeric_limits<double>::infinity();
  refuse_singular(from, from);
  knots_.assign(1, from);
  for (double step = 1; step <= steps; ++step) {
    const auto next = joints_of(flange(step / steps), knots_.back());
    if (!next) {
      throw ControllerRefusal(ControllerErrorCode::kOutOfReach,
                              "the line leaves the robot's reach");
    }
    refuse_singular(knots_.back(), *next);
    const std::string outside = outside_limits(*next);
    if (!outside.empty()) {
      throw ControllerRefusal(ControllerErrorCode::kJointLimit, "on the line " + outside);
    }
    const Joints turn = (*next - knots_.back()).cwiseAbs();
    const double share = (turn * steps).cwiseQuotient(joint_limits().speed).maxCoeff();
    max_speed = std::min(max_speed, 1 / std::max(share, kNothing));
    knots_.push_back(*next);
  }
  return max_speed;
}

/// @return the postures that reach the pose
std::vector<Joints> refuse_out_of_reach(const Eigen::Isometry3d& flange, const Joints& near) {
  std::vector<Joints> postures = postures_of(flange, near);
  if (!postures.empty()) return postures;
  throw ControllerRefusal(ControllerErrorCode::kOutOfReach, "no posture reaches the pose");
}

}  // namespace

PlannedPath plan_joint_path(const Joints& from, const Joints& to) {
  const std::string outside = outside_limits(to);
  if (!outside.empty()) throw ControllerRefusal(ControllerErrorCode::kJointLimit, outside);
  const Joints way = (to - from).cwiseAbs().cwiseMax(kNothing);
  PlannedPath plan;
  plan.path = std::make_shared<JointPath>(from, to);
  plan.speed = joint_limits().speed.cwiseQuotient(way).minCoeff();
  plan.max_speed = plan.speed;
  plan.acceleration = joint_limits().acceleration.cwiseQuotient(way).minCoeff();
  return plan;
}

PlannedPath plan_line(const Joints& from, const Eigen::Isometry3d& to,
                      const LineSettings& settings) {
  refuse_out_of_reach(to, from);  // before following it, which may take long
  const auto line = std::make_shared<LinePath>(flange_of(from), to, settings.euler);
  constexpr double kSpinUp = 4;  // [1/s] full rotational speed in a quarter of a second; chosen
  PlannedPath plan;
  plan.max_speed = line->follow(from);
  plan.speed = std::min(settings.speed / std::max(line->length(), kNothing),
                        settings.rotational_speed / std::max(line->angle(), kNothing));
  plan.acceleration =
      std::min(settings.acceleration / std::max(line->length(), kNothing),
               kSpinUp * settings.rotational_speed / std::max(line->angle(), kNothing));
  plan.path = line;
  return plan;
}

double flange_travel(const Path& path) {
  constexpr int kSteps = 256;  // chosen: the flange's speed is smooth over a path
  double longest = 0;
  Eigen::Vector3d before = path.flange(0).translation();
  for (int step = 1; step <= kSteps; ++step) {
    const Eigen::Vector3d here = path.flange(static_cast<double>(step) / kSteps).translation();
    longest = std::max(longest, kSteps * (here - before).norm());
    before = here;
  }
  return longest;
}

Joints reach(const Eigen::Isometry3d& flange, const Joints& near) {
  std::vector<Joints> postures = refuse_out_of_reach(flange, near);
  std::sort(postures.begin(), postures.end(), [&near](const Joints& one, const Joints& other) {
    return (one - near).norm() < (other - near).norm();
  });
  for (const Joints& joints : postures) {
    if (outside_limits(joints).empty()) return joints;
  }
  throw ControllerRefusal(ControllerErrorCode::kJointLimit, outside_limits(postures.front()));
}

}  // namespace scan_cell_sim
