// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/path.h"

#include <algorithm>
#include <vector>

#include "controller/arm/arc_path.h"
#include "controller/arm/line_path.h"

namespace scan_cell_sim {
namespace {

class JointPath : public Path {
 public:
  JointPath(const Joints& from, const Joints& to) : from_(from), to_(to) {}
  Joints joints(double way) const override { return from_ + way * (to_ - from_); }
  Eigen::Isometry3d flange(double way) const override { return flange_of(joints(way)); }

 private:
  Joints from_;
  Joints to_;
};

/// @return the postures that reach the pose
std::vector<Joints> refuse_out_of_reach(const Eigen::Isometry3d& flange, const Joints& near) {
  std::vector<Joints> postures = postures_of(flange, near);
  if (!postures.empty()) return postures;
  throw ControllerRefusal(ControllerErrorCode::kOutOfReach, "no posture reaches the pose");
}

PlannedPath plan(const Joints& from, const std::shared_ptr<FlangePath>& path,
                 const LineSettings& settings) {
  constexpr double kSpinUp = 4;  // [1/s] full rotational speed in a quarter of a second
  const double length = std::max(path->length(), kNothing);
  const double turning = std::max(path->turning(), kNothing);
  PlannedPath plan;
  plan.max_speed = path->follow(from);
  plan.speed = std::min(settings.speed / length, settings.rotational_speed / turning);
  plan.acceleration =
      std::min(settings.acceleration / length, kSpinUp * settings.rotational_speed / turning);
  plan.path = path;
  return plan;
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
  refuse_out_of_reach(to, from);  // before it is followed, however far away it is
  return plan(from, std::make_shared<LinePath>(flange_of(from), to, settings.euler), settings);
}

PlannedPath plan_arc(const Joints& from, const Eigen::Isometry3d& via, const Eigen::Isometry3d& to,
                     const LineSettings& settings) {
  const auto arc = std::make_shared<ArcPath>(flange_of(from), via, to);
  for (const Eigen::Isometry3d& pose : {via, to})
    refuse_out_of_reach(pose, from);
  return plan(from, arc, settings);
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
