// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/run_view.h"

#include <nlohmann/json.hpp>

#include "deviation/adapted_part.h"
#include "recipe/recipe.h"
#include "record/run_record.h"
#include "run/calls/recipe_reading.h"
#include "run/calls/stage_calls.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "tool_path_stretcher/reported_verdict.h"
#include "view/waypoints_concerned.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

tool_paths::ToolPath placed(tool_paths::ToolPath path, const AdaptedPart& part) {
  if (!part.similarity) return path;
  for (tool_paths::Segment& segment : path.segments) {
    for (tool_paths::Waypoint& waypoint : segment.waypoints) {
      waypoint.pose.translation() = *part.similarity * waypoint.pose.translation();
      waypoint.pose.linear() = part.similarity->rotation * waypoint.pose.linear();
    }
  }
  return path;
}

Eigen::Vector3d point_of(const nlohmann::json& list) {
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
}

std::vector<UnseenWaypoint> unseen_of(const fs::path& sight) {
  if (!fs::exists(sight)) return {};
  const std::string text = scan_cell_common::read_file(sight.string());
  try {
    std::vector<UnseenWaypoint> unseen;
    const auto all = nlohmann::json::parse(text);
    for (const auto& best : all.at("best")) {
      UnseenWaypoint waypoint = {best.at("sight").get<std::string>(), point_of(best.at("position")),
                                 std::nullopt};
      if (waypoint.sight == "seen") continue;
      if (!best.at("obstacle").is_null()) waypoint.obstacle = point_of(best.at("obstacle"));
      unseen.push_back(waypoint);
    }
    return unseen;
  } catch (const nlohmann::json::exception& error) {
    throw scan_cell_common::UnusableInput(sight.string(), error.what(), "run the part again");
  }
}

}  // namespace

RunView view_of(const fs::path& run) {
  const fs::path inputs = run / "inputs";
  const Recipe recipe = load_recipe(inputs);
  const RunRecord record = load_run(run);
  RunView view;
  view.verdict = to_string(record.state) + ": " + record.message;
  view.tolerance = record.tolerance;
  view.frame = recipe.frame();
  const fs::path report = run / "report.json";
  if (!fs::exists(report)) return view;
  const PathReading reading = reading_of(recipe.path);
  view.path = placed(load_path((inputs / recipe.path.file).string(), reading).path,
                     load_adapted_part({"", "", "", report.string()}));
  if (record.state == RunState::kAccepted) {
    view.adapted = load_path((run / path_name(recipe)).string(), reading).path;
    view.expected = tool_path_stretcher::load_report(report.string()).expected_errors;
  }
  view.unseen = unseen_of(run / "sight.json");
  view.concerned = waypoints_concerned(run);
  const tool_paths::Points all =
      positions_of(view.adapted.segments.empty() ? view.path : view.adapted);
  for (const std::uint32_t waypoint : view.concerned) {
    if (waypoint >= all.size())
      throw scan_cell_common::UnusableInput(report.string(), std::to_string(waypoint),
                                            "the path has no such waypoint; run the part again");
    view.positions.push_back(all[waypoint]);
  }
  return view;
}

}  // namespace part_recipes
