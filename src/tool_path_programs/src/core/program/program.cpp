// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_programs/program.h"

#include <cmath>

#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

bool is_pose(const Eigen::Isometry3d& pose) {
  return pose.matrix().allFinite() && pose.linear().isUnitary(1e-6) &&
         pose.linear().determinant() > 0;
}

/// What is wrong with a move; empty: nothing.
std::string fault_of(const Move& move, std::size_t frames) {
  if (!is_pose(move.pose)) return "its pose is not finite, or its rotation is invalid";
  if (move.kind == MotionKind::kCircular && !move.via) return "a circular move without via";
  if (move.via && !is_pose(*move.via)) return "its via is not finite, or its rotation is invalid";
  if (!(move.zone >= 0) || !std::isfinite(move.zone)) return "zone " + std::to_string(move.zone);
  if (move.kind == MotionKind::kJoint) {
    if (!(move.joint_speed > 0 && move.joint_speed <= 1))
      return "joint speed " + std::to_string(move.joint_speed) + ", not a share from 0 to 1";
  } else if (!(move.speed > 0) || !std::isfinite(move.speed)) {
    return "speed " + std::to_string(move.speed) + " m/s";
  }
  return move.frames < frames ? "" : "its frames are not in the program";
}

}  // namespace

std::vector<const Move*> moves_of(const Program& program) {
  std::vector<const Move*> moves;
  for (const Step& step : program.steps)
    if (const Move* move = std::get_if<Move>(&step)) moves.push_back(move);
  return moves;
}

void check(const Program& program) {
  const std::vector<const Move*> moves = moves_of(program);
  if (moves.empty())
    throw UnusableInput("program " + program.name, "no move", "give a path with waypoints");
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const std::string fault = fault_of(*moves[i], program.frames.size());
    if (!fault.empty())
      throw UnusableInput("program " + program.name + ", waypoint " + std::to_string(i + 1), fault,
                          "give finite poses, speeds above 0 and zones from 0 up");
  }
}

}  // namespace tool_path_programs
