// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_planner/reach.h"

#include <fmt/format.h>

#include "c4g_driver/motion_plan.h"
#include "scan_cell/scan_run.h"
#include "scan_cell_common/errors/errors.h"

namespace pass_planner {
namespace {

using c4g_driver::Motion;
using c4g_driver::PlannedMotion;
using scan_cell::ScanPass;

Motion motion_to(const scan_cell::MoveTarget& target, const Eigen::Isometry3d& to_base) {
  Motion motion;
  motion.flange = to_base * target.flange;
  if (!target.via) return motion;
  motion.kind = Motion::Kind::kAlongArc;
  motion.via = to_base * *target.via;
  return motion;
}

}  // namespace

Eigen::Isometry3d base_link_in_frame(const RobotInCell& robot) {
  if (robot.frame == "world") return robot.base_link_in_world;
  if (robot.frame == "base_link") return Eigen::Isometry3d::Identity();
  throw scan_cell_common::InvalidParameter(
      "frame", robot.frame,
      "give part and program in world or base_link: where the robot stands in another frame is not "
      "known");
}

Reach::Reach(const RobotInCell& robot)
    : robot_(robot),
      model_(robot.urdf, "base_link", "flange"),
      base_link_(base_link_in_frame(robot)) {
  robot_.limits = narrowed(robot.limits, model_);
}

Eigen::Isometry3d Reach::start() const {
  return base_link_ * model_.flange_at(robot_.start);
}

Eigen::Isometry3d Reach::frame_in_world() const {
  return robot_.base_link_in_world * base_link_.inverse();
}

std::string Reach::refusal(const std::vector<ScanPass>& passes) const {
  const Eigen::Isometry3d to_base = base_link_.inverse();
  std::vector<PlannedMotion> plan;
  std::vector<std::size_t> pass_of;
  for (const scan_cell::ScanRun& run : runs_of(passes)) {
    if (run.approach)
      plan.push_back({motion_to({run.start, std::nullopt}, to_base), robot_.approach_speed});
    for (const scan_cell::MoveTarget& target : run.moves)
      plan.push_back({motion_to(target, to_base), run.speed});
    pass_of.resize(plan.size(), run.pass);
  }
  c4g_driver::RobotState from;
  from.joints = robot_.start;
  from.flange = model_.flange_at(robot_.start);
  const c4g_driver::PlanCheck check = check_plan(model_, robot_.limits, from, {}, plan);
  if (check.refusal.empty()) return "";
  const std::size_t pass = pass_of[check.ends.size()];
  return pass_name(passes[pass], pass) + ": " + check.refusal;
}

}  // namespace pass_planner
