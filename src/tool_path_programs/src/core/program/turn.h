// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "tool_path_programs/program.h"

namespace tool_path_programs {

/// [rad] turn in one step from which the direction of the turn is ambiguous.
constexpr double kOpenTurn = 179.9 * M_PI / 180;

/// [rad] turn of the tool from one pose to the other, the shorter way.
inline double turn_between(const Move& from, const Move& to) {
  return Eigen::Quaterniond(from.pose.linear())
      .angularDistance(Eigen::Quaterniond(to.pose.linear()));
}

}  // namespace tool_path_programs
