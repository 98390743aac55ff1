// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "history/chart/run_chart.h"
#include "scan_cell_common/pose/units.h"

namespace part_recipes {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;
using scan_cell_common::kMillimetres;

/// Positions on the axis, from 1.
Json positions(const std::vector<std::size_t>& indices, const std::vector<std::size_t>& counted) {
  Json all = Json::array();
  for (const std::size_t index : indices)
    all.push_back(counted[index] + 1);
  return all;
}

Json interval(const Interval& interval, double unit) {
  return {interval.lower * unit, interval.upper * unit};
}

Json limits(const CharacteristicChart& chart, double unit) {
  if (!chart.limits) return nullptr;
  const IndividualsChart& limits = *chart.limits;
  Json ranges = Json::array();
  for (std::size_t i = 0; i < limits.moving_ranges.size(); ++i)
    ranges.push_back({chart.counted[i + 1] + 1, limits.moving_ranges[i] * unit});
  const bool has_lower = !chart.is_positive || limits.lower > 0;
  return {{"count", limits.count},
          {"mean", limits.mean * unit},
          {"lower", has_lower ? Json(limits.lower * unit) : Json(nullptr)},
          {"upper", limits.upper * unit},
          {"moving_range_mean", limits.moving_range_mean * unit},
          {"moving_range_upper", limits.moving_range_upper * unit},
          {"moving_ranges", ranges},
          {"wide_ranges", positions(limits.wide_ranges, chart.counted)}};
}

Json capability(const CharacteristicChart& chart, double unit) {
  if (const auto* const none = std::get_if<NoCapability>(&chart.capability))
    return {{"none", to_string(*none)}, {"because", in_words(*none)}};
  const auto& found = std::get<Capability>(chart.capability);
  return {{"from", chart.counted[found.first] + 1},
          {"count", found.count},
          {"standard_deviation", found.standard_deviation * unit},
          {"cp", found.cp},
          {"cp_interval", interval(found.cp_interval, 1)},
          {"cpk", found.cpk},
          {"cpk_interval", interval(found.cpk_interval, 1)}};
}

Json values(const CharacteristicChart& chart, double unit) {
  Json all = Json::array();
  for (const auto& value : chart.values)
    all.push_back(value ? Json(*value * unit) : Json(nullptr));
  return all;
}

Json json_of(const CharacteristicChart& chart) {
  const double unit = chart.is_length ? kMillimetres : 1;
  Json breaks = Json::array();
  for (const RuleBreak& broken : chart.breaks) {
    breaks.push_back({{"rule", broken.rule},
                      {"at", chart.counted[broken.at] + 1},
                      {"points", positions(broken.points, chart.counted)}});
  }
  return {{"name", chart.name},
          {"kind", chart.kind == CharacteristicChart::Kind::kPlace ? "place" : "figure"},
          {"unit", chart.is_length ? "mm" : ""},
          {"values", values(chart, unit)},
          {"limits", limits(chart, unit)},
          {"rule_breaks", breaks},
          {"tolerance", chart.tolerance ? interval(*chart.tolerance, unit) : Json(nullptr)},
          {"capability", capability(chart, unit)}};
}

}  // namespace

std::string to_json(const RunCharts& charts) {
  Json all = {{"format", kFormat},          {"recipe", charts.recipe},
              {"runs", Json::array()},      {"repeats_left_out", charts.repeats},
              {"refusals", Json::object()}, {"charts", Json::array()}};
  for (const ChartRun& run : charts.runs) {
    all["runs"].push_back({{"id", run.id},
                           {"started", run.started},
                           {"state", to_string(run.state)},
                           {"reason", run.reason},
                           {"time_went_back", run.is_time_back},
                           {"recipe_changed", run.is_recipe_changed}});
  }
  for (const auto& [reason, count] : charts.refusals)
    all["refusals"][reason] = count;
  for (const CharacteristicChart& chart : charts.charts)
    all["charts"].push_back(json_of(chart));
  // Names of people; the database holds what run.json held, which is UTF-8.
  return all.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace part_recipes
