// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/chart/run_chart.h"

#include <algorithm>
#include <functional>
#include <set>

namespace part_recipes {
namespace {

using Value = std::function<std::optional<double>(const RunRecord&)>;
using Runs = std::vector<const RunRecord*>;

void add_axis(RunCharts& charts, const Runs& runs) {
  const RunRecord* before = nullptr;
  for (const RunRecord* const run : runs) {
    ChartRun shown{run->id, run->started, run->reason, run->state, false, false};
    if (before != nullptr) {
      shown.is_time_back = run->started < before->started;
      shown.is_recipe_changed = run->recipe_sha256 != before->recipe_sha256;
    }
    charts.runs.push_back(shown);
    if (run->state != RunState::kAccepted) ++charts.refusals[run->reason];
    before = run;
  }
}

/// Capability of a place: whether it keeps within the tolerance of the counted runs.
std::variant<Capability, NoCapability> capability_of_place(CharacteristicChart& chart,
                                                           const Runs& runs,
                                                           const std::vector<double>& values) {
  std::set<double> tolerances;
  for (const std::size_t run : chart.counted)
    tolerances.insert(runs[run]->tolerance);
  if (chart.counted.empty()) return NoCapability::kTooFewValues;
  const double tolerance = runs[chart.counted.back()]->tolerance;
  if (tolerance <= 0) return NoCapability::kNoTolerance;
  chart.tolerance = Interval{-tolerance, tolerance};
  if (tolerances.size() > 1) return NoCapability::kToleranceChanged;
  return capability(values, chart.tolerance);
}

void add_values(CharacteristicChart& chart, const Runs& runs, const Value& value) {
  std::vector<double> counted;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    chart.values.push_back(value(*runs[run]));
    if (runs[run]->state != RunState::kAccepted || !chart.values.back()) continue;
    chart.counted.push_back(run);
    counted.push_back(*chart.values.back());
  }
  chart.limits = individuals_chart(counted);
  if (chart.limits)
    chart.breaks = western_electric(counted, chart.limits->mean, chart.limits->sigma);
  if (chart.kind == CharacteristicChart::Kind::kPlace)
    chart.capability = capability_of_place(chart, runs, counted);
}

CharacteristicChart figure_chart(const Runs& runs, const std::string& name,
                                 std::optional<double> RunFigures::*member, bool is_length) {
  CharacteristicChart chart;
  chart.name = name;
  chart.is_length = is_length;
  chart.is_positive = true;
  add_values(chart, runs, [member](const RunRecord& run) { return run.figures.*member; });
  return chart;
}

CharacteristicChart place_chart(const Runs& runs, const std::string& name) {
  CharacteristicChart chart;
  chart.name = name;
  chart.kind = CharacteristicChart::Kind::kPlace;
  add_values(chart, runs, [&name](const RunRecord& run) -> std::optional<double> {
    const auto found = run.figures.places.find(name);
    return found != run.figures.places.end() ? found->second : std::nullopt;
  });
  return chart;
}

}  // namespace

RunCharts run_charts(const std::string& recipe, const std::vector<HistoryRun>& all) {
  RunCharts charts;
  charts.recipe = recipe;
  Runs runs;
  std::set<std::string> places;
  for (const HistoryRun& run : all) {
    if (!run.record.again_of.empty()) {
      ++charts.repeats;
      continue;
    }
    runs.push_back(&run.record);
    for (const auto& [name, deviation] : run.record.figures.places)
      places.insert(name);
  }
  add_axis(charts, runs);
  charts.charts.push_back(figure_chart(runs, "scale", &RunFigures::scale, false));
  charts.charts.push_back(figure_chart(runs, "rms", &RunFigures::rms, true));
  charts.charts.push_back(
      figure_chart(runs, "largest displacement", &RunFigures::largest_displacement, true));
  for (const std::string& name : places)
    charts.charts.push_back(place_chart(runs, name));
  return charts;
}

}  // namespace part_recipes
