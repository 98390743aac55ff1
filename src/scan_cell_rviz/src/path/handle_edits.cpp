// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path/handle_edits.h"

namespace scan_cell_rviz {

using tool_paths::EditFrame;

std::vector<tool_paths::PathEdit> edits_between(const Eigen::Isometry3d& before,
                                                const Eigen::Isometry3d& after, bool can_turn,
                                                const tool_paths::WaypointRange& waypoints) {
  constexpr double kLeastMove = 1e-6;  // [m] smaller than a deliberate mouse movement; chosen
  constexpr double kLeastTurn = 1e-5;  // [rad] chosen
  std::vector<tool_paths::PathEdit> edits;
  const Eigen::Vector3d by = after.translation() - before.translation();
  if (by.norm() > kLeastMove) {
    if (can_turn)
      edits.push_back(tool_paths::MoveEdit{waypoints, before.linear().transpose() * by});
    else
      edits.push_back(tool_paths::MoveEdit{waypoints, by, EditFrame::kPath});
  }
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(before.linear().transpose() * after.linear()));
  if (can_turn && turn.angle() > kLeastTurn)
    edits.push_back(tool_paths::TurnEdit{waypoints, turn.axis(), turn.angle()});
  return edits;
}

}  // namespace scan_cell_rviz
