// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_planner/sight_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace pass_planner {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN: null means not known.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json list(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

Json to_json(const Sighting& sighting) {
  return {{"sight", to_string(sighting.sight)},
          {"fault", to_string(sighting.fault)},
          {"light_angle", number(sighting.light_angle)},
          {"sight_angle", number(sighting.sight_angle)},
          {"obstacle", sighting.obstacle ? list(*sighting.obstacle) : Json(nullptr)}};
}

Json best_of(std::size_t waypoint, const Surface::Place& place, const PathSight& sight) {
  const Sighting& best = sight.best[waypoint];
  Json json = {{"waypoint", waypoint}, {"position", list(place.point)}};
  json["pass"] = sight.sweeps[best.sweep].pass;
  json["laser"] = sight.sweeps[best.sweep].laser;
  json.update(to_json(best));
  return json;
}

}  // namespace

std::string sight_to_json(const std::vector<Surface::Place>& places, const PathSight& sight,
                          const std::vector<scan_cell::ScanPass>& passes) {
  Json report = {{"waypoints", places.size()}, {"seen", sight.count(Sight::kSeen)}};
  report["not_seen"] = sight.not_seen();
  report["best"] = Json::array();
  for (std::size_t i = 0; i < places.size(); ++i)
    report["best"].push_back(best_of(i, places[i], sight));
  report["sweeps"] = Json::array();
  for (std::size_t s = 0; s < sight.sweeps.size(); ++s) {
    const Sweep& sweep = sight.sweeps[s];
    Json waypoints = Json::array();
    for (const Sighting& sighting : sight.of_sweeps[s])
      waypoints.push_back(to_json(sighting));
    report["sweeps"].push_back({{"pass", sweep.pass},
                                {"name", pass_name(passes[sweep.pass], sweep.pass)},
                                {"laser", sweep.laser},
                                {"waypoints", waypoints}});
  }
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summary_of(const PathSight& sight) {
  const std::pair<Sight, std::pair<Fault, const char*>> kinds[] = {
      {Sight::kShadowed, {Fault::kLight, "in the shadow of the laser's light"}},
      {Sight::kShadowed, {Fault::kSight, "hidden from the camera"}},
      {Sight::kGrazing, {Fault::kLight, "at too grazing an angle to the light"}},
      {Sight::kGrazing, {Fault::kSight, "at too grazing an angle to the camera's sight"}},
      {Sight::kOutOfRange, {Fault::kImage, "outside the image"}},
      {Sight::kOutOfRange, {Fault::kDepth, "too near to the camera or too far"}},
      {Sight::kOutOfRange, {Fault::kNotPassed, "where no laser passes"}}};
  std::string text =
      fmt::format("{} of {} waypoints seen", sight.count(Sight::kSeen), sight.best.size());
  for (const auto& [kind, why] : kinds) {
    std::size_t count = 0;
    for (const Sighting& sighting : sight.best)
      count += sighting.sight == kind && sighting.fault == why.first;
    if (count > 0) text += fmt::format("; {} {}", count, why.second);
  }
  return text;
}

}  // namespace pass_planner
