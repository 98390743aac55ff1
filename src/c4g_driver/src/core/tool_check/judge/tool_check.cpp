// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/tool_check.h"

#include "scan_cell_common/parameters/parameter_table.h"

namespace c4g_driver {

void describe(scan_cell_common::ParameterTable& table, ToolCheckParameters& parameters) {
  table.add("joint_margin", parameters.joint_margin, {0, 1, "rad"},
            "distance that each joint keeps from the ends of its range");
  table.add("free_about_z", parameters.free_about_z,
            "the tool may turn freely about its z axis, as in sanding or spraying");
  table.add("rotational_speed", parameters.rotational_speed, {1e-3, 10, "rad/s"},
            "of the tool, where it turns more than it moves");
}

const char* to_string(ToolFault::Kind kind) {
  constexpr std::array<const char*, 10> kNames = {
      "half_turn",  "tool_speed", "reach",       "posture",   "singular",
      "turns_over", "workspace",  "joint_range", "collision", "joint_speed"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::string ToolCheck::refusal() const {
  return possible() ? "" : faults.front().what();
}

}  // namespace c4g_driver
