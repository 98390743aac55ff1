// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "checked_robot.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "c4g_driver/cell_shapes.h"
#include "c4g_driver/collision_scene.h"
#include "c4g_driver/tool_motion_check.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace tool_path_programs {
namespace {

using c4g_driver::ToolMotion;
using scan_cell_common::InvalidParameter;
using scan_cell_common::Refused;

RobotOptions read(RobotOptions options) {
  options.typed.read(options.limits);
  options.typed.read(options.check);
  return options;
}

const Eigen::Isometry3d& place_of(const Frame& frame, const std::string& what) {
  if (frame.pose) return *frame.pose;
  throw InvalidParameter("--robot", "the place of the " + what + " is not known",
                         "give --cell, too");
}

/// A first move by the joints counts as its end point only.
ToolMotion motion_of(const Program& program) {
  const Frames& frames = program.frames.front();
  ToolMotion motion;
  motion.flange_to_tip = place_of(frames.tool, "tool");
  const Eigen::Isometry3d& base = place_of(frames.user, "user frame");
  for (const Move* move : moves_of(program))
    motion.waypoints.push_back({base * move->pose, move->speed, move->zone, 0});
  return motion;
}

c4g_driver::RobotState state_of(const RobotOptions& options, const c4g_driver::RobotModel& model) {
  constexpr std::size_t kJoints = 6;
  c4g_driver::RobotState state;
  state.mode = c4g_driver::ControllerMode::kRemote;
  if (!options.start.empty() && options.start.size() != kJoints)
    throw InvalidParameter("--start", fmt::format("{} joints", options.start.size()), "give six");
  if (!options.start.empty()) state.joints = c4g_driver::Joints(options.start.data());
  state.flange = model.flange_at(state.joints);
  return state;
}

}  // namespace

void RobotOptions::add(CLI::App& app) {
  app.add_option("--robot", urdf,
                 "URDF of a six-axis arm: reach, joints, singular postures and speeds are checked, "
                 "and arm configurations written where the language has them; needs --cell");
  app.add_option("--base", base, "link of the URDF that the arm stands on")->capture_default_str();
  app.add_option("--flange", flange, "link of the URDF that carries the tool")
      ->capture_default_str();
  app.add_option("--start", start, "[rad] joints of a posture near which the arm works");
  app.add_option("--shapes", shapes, "YAML: what must not collide (docs/c4g_driver.md)");
  limits.operation = c4g_driver::Operation::kAutomatic;
  typed.add(app, limits,
            {"operation", "workspace_min", "workspace_max", "joint_lower", "joint_upper",
             "max_linear_speed"});
  typed.add(app, check);
}

CheckedRobot::CheckedRobot(RobotOptions options)
    : options_(read(std::move(options))),
      model_(scan_cell_common::read_file(options_.urdf), options_.base, options_.flange) {}

std::vector<std::string> CheckedRobot::check(Program& program) const {
  using namespace c4g_driver;
  const RobotLimits limits = narrowed(options_.limits, model_);
  const ToolMotion motion = motion_of(program);
  std::optional<CollisionScene> scene;
  if (!options_.shapes.empty()) scene.emplace(model_, read_cell_shapes(options_.shapes));
  const ToolCheck found = check_tool_motion(model_, limits, state_of(options_, model_), motion,
                                            options_.check, scene ? &*scene : nullptr);
  if (!found.possible())
    throw Refused(
        "robot",
        fmt::format("{} ({} places in all)", found.faults.front().what(), found.faults.size()),
        "the program's moves are counted from 0");
  const Eigen::Isometry3d to_user = place_of(program.frames.front().user, "user frame").inverse();
  std::size_t waypoint = 0;
  for (Step& step : program.steps) {
    Move* move = std::get_if<Move>(&step);
    if (!move) continue;
    move->pose = to_user * found.tips[waypoint];  // the free turn was chosen
    const Joints& joints = found.joints[waypoint++];
    move->joints.emplace();
    std::copy(joints.begin(), joints.end(), move->joints->begin());
  }
  std::vector<std::string> notes = {"the robot can run it"};
  if (found.slowest)
    notes.push_back(fmt::format("slowest at move {}: at most {:.3g} mm/s there, {:.3g} wanted",
                                found.slowest->waypoint, 1e3 * found.slowest->speed,
                                1e3 * found.slowest->wanted));
  return notes;
}

}  // namespace tool_path_programs
