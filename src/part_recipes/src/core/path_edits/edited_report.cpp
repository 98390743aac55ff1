// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_edits/edited_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/sha256.h"

namespace part_recipes {
namespace {

using Json = nlohmann::ordered_json;
using tool_paths::WaypointOrigin;

constexpr std::array<const char*, 4> kExpectedErrors = {
    "expected_error_normal", "expected_error_tangential", "expected_error_across",
    "expected_error_orientation"};

/// Null (not known) is worse than any number.
Json worse(const Json& one, const Json& other) {
  if (one.is_null() || other.is_null()) return nullptr;
  return std::max(one.get<double>(), other.get<double>());
}

Json quality_of(const WaypointOrigin& origin, const Json& before) {
  Json quality = before.at(origin.first);
  const Json& other = before.at(origin.second);
  if (!quality.contains("unedited_waypoint")) quality["unedited_waypoint"] = origin.first;
  if (origin.added) {
    quality["unedited_waypoint"] = nullptr;
    for (const char* name : kExpectedErrors)
      quality[name] = worse(quality.at(name), other.at(name));
    for (const char* name : {"measured", "position_measured"})
      quality[name] = quality.at(name).get<bool>() && other.at(name).get<bool>();
    quality["in_air"] = quality.at("in_air").get<bool>() || other.at("in_air").get<bool>();
  }
  quality[tool_paths::kEditedValue] =
      origin.edited || quality.value(tool_paths::kEditedValue, false);
  return quality;
}

Json all_quality(const tool_paths::EditedPath& edited, const Json& before) {
  Json all = Json::array();
  std::size_t number = 0;
  for (std::size_t s = 0; s < edited.path.segments.size(); ++s) {
    for (std::size_t w = 0; w < edited.path.segments[s].waypoints.size(); ++w) {
      Json quality = quality_of(edited.origins[number++], before);
      quality["segment"] = s;
      quality["waypoint"] = w;
      all.push_back(quality);
    }
  }
  return all;
}

/// Largest value over the waypoints that are not in the air; null if it is not known for one of
/// them.
Json largest(const Json& quality, const char* name) {
  Json most = 0.0;
  bool any = false;
  for (const Json& each : quality) {
    if (each.at("in_air").get<bool>()) continue;
    any = true;
    most = worse(most, each.at(name));
  }
  return any ? most : Json(nullptr);
}

/// Counts again what the report says before its list of waypoints.
void count_again(Json& report) {
  const Json& quality = report.at("quality");
  std::size_t measured = 0, in_air = 0;
  for (const Json& each : quality) {
    in_air += each.at("in_air").get<bool>() ? 1 : 0;
    measured += !each.at("in_air").get<bool>() && each.at("measured").get<bool>() ? 1 : 0;
  }
  report["measured_waypoints"] = measured;
  report["waypoints_in_air"] = in_air;
  report["inferred_waypoints"] = quality.size() - measured - in_air;
  report["largest_displacement"] = largest(quality, "displacement");
  for (const char* name :
       {"expected_error_normal", "expected_error_tangential", "expected_error_orientation"})
    report[std::string("largest_") + name] = largest(quality, name);
}

void renumber_concerned(const std::vector<WaypointOrigin>& origins, Json& report) {
  Json concerned = Json::array();
  for (std::size_t i = 0; i < origins.size(); ++i)
    for (const Json& before : report.at("waypoints_concerned"))
      if (before.get<std::size_t>() == origins[i].first && !origins[i].added)
        concerned.push_back(i);
  report["waypoints_concerned"] = concerned;
}

void add_edits(const DoneEdits& done, Json& report) {
  Json all = report.value("edits", Json{{"sha256", ""}, {"done", Json::array()}});
  const std::string chain = all.at("sha256").get<std::string>() + done.sha256;
  all["sha256"] = scan_cell_common::sha256_of(chain, "edits");
  for (const tool_paths::PathEdit& edit : done.edits)
    all["done"].push_back(to_string(edit));
  report["edits"] = all;
}

Json edited_json(Json report, const tool_paths::EditedPath& edited, const DoneEdits& done,
                 const tool_path_stretcher::FileRecord& output) {
  report["quality"] = all_quality(edited, report.at("quality"));
  count_again(report);
  renumber_concerned(edited.origins, report);
  for (Json& candidate : report.at("candidates"))
    candidate["waypoints"] = Json::array();  // where they would be of the path before
  report.at("path")["waypoints"] = edited.origins.size();
  report.at("path")["segments"] = edited.path.segments.size();
  report.at("files")["output"] = {
      {"name", output.name}, {"sha256", output.sha256}, {"units", output.units}};
  add_edits(done, report);
  return report;
}

}  // namespace

std::string edited_report(const UneditedReport& unedited, const tool_paths::EditedPath& edited,
                          const DoneEdits& done, const tool_path_stretcher::FileRecord& output) {
  try {
    const Json report = Json::parse(unedited.text);
    const std::size_t known = report.at("quality").size();
    for (const WaypointOrigin& origin : edited.origins)
      if (std::max(origin.first, origin.second) >= known)
        throw scan_cell_common::UnusableInput(unedited.name,
                                              fmt::format("is of a path with {} waypoints", known),
                                              "give the report that stretch wrote with the path");
    constexpr int kIndent = 2;
    return edited_json(report, edited, done, output).dump(kIndent) + "\n";
  } catch (const Json::exception& error) {
    throw scan_cell_common::UnusableInput(unedited.name, error.what(),
                                          "give a report that stretch wrote");
  }
}

}  // namespace part_recipes
