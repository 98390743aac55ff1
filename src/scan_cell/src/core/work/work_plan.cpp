// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "work/work_plan.h"

#include <fmt/format.h>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace scan_cell {
namespace {

using tool_path_programs::Move;
using tool_path_programs::Program;
using tool_path_programs::SetOutput;
using tool_path_programs::Step;
using tool_paths::ToolPath;

/// The part of the path from one of its waypoints on.
ToolPath from_waypoint(ToolPath path, std::size_t from) {
  const std::size_t count = waypoint_count(path);
  if (count > 0 && from >= count)
    throw scan_cell_common::Refused("waypoint " + std::to_string(from + 1),
                                    fmt::format("the path has {}", count),
                                    "begin with one of them");
  auto segment = path.segments.begin();
  while (segment != path.segments.end() && from >= segment->waypoints.size()) {
    from -= segment->waypoints.size();
    ++segment;
  }
  if (from > 0)
    segment->waypoints.erase(segment->waypoints.begin(),
                             segment->waypoints.begin() + static_cast<std::ptrdiff_t>(from));
  path.segments.erase(path.segments.begin(), segment);
  return path;
}

std::vector<std::size_t> shifted(const std::vector<std::size_t>& waypoints, std::size_t from) {
  std::vector<std::size_t> result;
  for (const std::size_t waypoint : waypoints)
    if (waypoint >= from) result.push_back(waypoint - from);
  return result;
}

std::uint32_t bit_of(const std::string& output) {
  if (output.empty()) return 0;
  const auto number = scan_cell_common::parse_count(output);
  if (!number || *number < 1 || *number > 32)
    throw scan_cell_common::InvalidParameter("tool_output", output,
                                             "give the output's number, 1 to 32");
  return std::uint32_t{1} << (*number - 1);
}

void make_dry(WorkPlan& plan, const DryRun& dry) {
  for (WorkWaypoint& waypoint : plan.waypoints) {
    waypoint.tip = waypoint.tip * Eigen::Translation3d(0, 0, -dry.lift);
    waypoint.speed *= dry.speed;
    waypoint.outputs = 0;
  }
}

}  // namespace

WorkPlan plan_of(const ToolPath& path, const tool_path_programs::ExportParameters& parameters,
                 const std::vector<std::size_t>& in_air, std::size_t from,
                 const std::optional<DryRun>& dry) {
  const std::uint32_t bit = bit_of(parameters.tool_output);
  const Program program = tool_path_programs::program_of(from_waypoint(path, from), parameters, {},
                                                         shifted(in_air, from));
  WorkPlan plan;
  plan.joint_speed = parameters.joint_speed;
  std::uint32_t outputs = 0;
  for (const Step& step : program.steps) {
    if (const Move* move = std::get_if<Move>(&step)) {
      const bool by_joints = move->kind == tool_path_programs::MotionKind::kJoint;
      const double speed = by_joints ? parameters.travel_speed : move->speed;
      std::optional<std::size_t> waypoint;
      if (move->waypoint) waypoint = *move->waypoint + from;
      plan.waypoints.push_back({move->pose, speed, move->zone, outputs, waypoint});
    } else if (const SetOutput* output = std::get_if<SetOutput>(&step)) {
      outputs = output->on ? bit : 0;
      plan.waypoints.back().outputs = outputs;
    }
  }
  if (dry) make_dry(plan, *dry);
  return plan;
}

}  // namespace scan_cell
