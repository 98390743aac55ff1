// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "deviation/deviation_files.h"

#include <cstring>
#include <nlohmann/json.hpp>

#include "deviation/statistics.h"
#include "scan_cell_common/clouds/fielded_cloud.h"

namespace part_recipes {
namespace {

using Json = nlohmann::ordered_json;

Json number(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const PlaceDeviation& measured) {
  const Eigen::Vector3d& at = measured.place.position;
  return {{"name", measured.place.name},
          {"position", {at.x(), at.y(), at.z()}},
          {"radius", measured.place.radius},
          {"deviation", number(measured.deviation)},
          {"points", measured.points}};
}

}  // namespace

std::string to_json(const DeviationSummary& summary) {
  const DeviationStatistics statistics =
      statistics_of(summary.deviations.values, summary.tolerance);
  Json places = Json::array();
  for (const PlaceDeviation& place : summary.places)
    places.push_back(json_of(place));
  const Json all = {{"tolerance", summary.tolerance},
                    {"points", statistics.points},
                    {"unknown_points", statistics.unknown},
                    {"rms", number(statistics.rms)},
                    {"median", number(statistics.median)},
                    {"min", number(statistics.min)},
                    {"max", number(statistics.max)},
                    {"within_tolerance_share", number(statistics.within_tolerance)},
                    {"places", places},
                    {"unscanned_share", summary.unscanned_share},
                    {"outside_known_by", to_string(summary.outside)},
                    {"reach", summary.deviations.reach.normal},
                    {"spacing", summary.deviations.reach.lateral}};
  constexpr int kIndent = 2;
  return all.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

void save_fields(const std::string& file, const Points& points,
                 const std::vector<std::string>& names,
                 const std::vector<std::vector<double>>& fields) {
  using scan_cell_common::FieldType;
  scan_cell_common::FieldedCloud cloud;
  for (const char* axis : {"x", "y", "z"}) {
    cloud.fields.push_back({axis, FieldType::kFloat32, cloud.step});
    cloud.step += sizeof(float);
  }
  for (const std::string& name : names) {
    cloud.fields.push_back({name, FieldType::kFloat32, cloud.step});
    cloud.step += sizeof(float);
  }
  cloud.bytes.resize(points.size() * cloud.step);
  std::vector<float> values(3 + names.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Eigen::Map<Eigen::Vector3f>{values.data()} = points[i].cast<float>();
    for (std::size_t field = 0; field < names.size(); ++field)
      values[3 + field] = static_cast<float>(fields[field][i]);
    std::memcpy(cloud.bytes.data() + i * cloud.step, values.data(), cloud.step);
  }
  save_cloud(file, cloud.view());
}

}  // namespace part_recipes
