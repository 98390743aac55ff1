// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <nlohmann/json.hpp>

#include "scan_cell_common/files/files.h"
#include "scanner_views/figures/view_table.h"

namespace scanner_views {
namespace {

nlohmann::ordered_json json_of(const Outcome& outcome) {
  nlohmann::ordered_json json;
  json["verdict"] = outcome.answer.verdict;
  json["is"] = to_string(outcome.worth);
  if (!outcome.answer.message.empty()) json["message"] = outcome.answer.message;
  json["seconds"] = outcome.answer.seconds;
  const Errors& errors = outcome.errors;
  if (errors.waypoints == 0) return json;
  json["waypoints"] = errors.waypoints;
  json["normal_rms_m"] = errors.normal;
  json["tangential_rms_m"] = errors.tangential;
  json["angle_rms_rad"] = errors.angle;
  json["position_rms_m"] = errors.position;
  json["worst_normal_m"] = errors.worst_normal;
  json["worst_position_m"] = errors.worst_position;
  json["worst_angle_rad"] = errors.worst_angle;
  const Expectations& as = errors.expectations;
  if (as.waypoints == 0) return json;
  json["normal_as_expected"] = as.normal;
  json["tangential_as_expected"] = as.along;
  json["with_expected_angle"] = as.with_angle;
  json["angle_as_expected"] = as.angle;
  json["truly_within_half_a_millimetre_along"] = as.truly_along;
  json["of_these_expected_within_two_millimetres"] = as.known_along;
  json["largest_expected_along_m"] = as.largest_along;
  return json;
}

}  // namespace

void save_json(const std::string& file, std::uint64_t seed,
               const std::vector<CaseResult>& results) {
  nlohmann::ordered_json json;
  json["seed"] = seed;
  for (const CaseResult& result : results) {
    nlohmann::ordered_json line;
    line["family"] = result.family;
    line["case"] = result.name;
    line["to_accept"] = result.to_accept;
    line["object_points"] = result.points;
    line["here"] = json_of(result.ours);
    for (std::size_t i = 0; i < result.others.size(); ++i)
      line["yardsticks"][yardsticks()[i]] = json_of(result.others[i]);
    json["cases"].push_back(line);
  }
  scan_cell_common::save_text(file, json.dump(1) + "\n");
}

}  // namespace scanner_views
