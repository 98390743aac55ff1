// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "history/history_rows.h"
#include "statistics/capability.h"
#include "statistics/individuals_chart.h"
#include "statistics/western_electric.h"

namespace part_recipes {

/// A run on the axis of a chart.
struct ChartRun {
  std::string id, started, reason;
  RunState state = RunState::kUnusable;
  bool is_time_back = false;       //!< started before the previous run on the axis
  bool is_recipe_changed = false;  //!< has other files of the recipe than the previous run
};

/// A figure of the runs, in their order. Lengths are metres.
struct CharacteristicChart {
  enum class Kind { kFigure, kPlace };

  std::string name;  //!< of the figure, or of the place as people gave it
  Kind kind = Kind::kFigure;
  bool is_length = true;                      //!< false: a ratio
  bool is_positive = false;                   //!< a limit below 0 means nothing
  std::vector<std::optional<double>> values;  //!< of each run on the axis; none: not known
  std::vector<std::size_t> counted;           //!< runs whose values enter the statistics
  std::optional<IndividualsChart> limits;     //!< none: fewer than two values
  std::vector<RuleBreak> breaks;              //!< indices into `counted`
  std::optional<Interval> tolerance;          //!< of the last counted run
  std::variant<Capability, NoCapability> capability = NoCapability::kNoTolerance;
};

/// The charts of a recipe.
struct RunCharts {
  std::string recipe;
  std::vector<ChartRun> runs;                   //!< the axis: in the order in which they were added
  std::size_t repeats = 0;                      //!< runs left out: they repeat another run's data
  std::map<std::string, std::size_t> refusals;  //!< runs that were not accepted, by reason
  std::vector<CharacteristicChart> charts;      //!< scale, rms, largest displacement, each place
};

/// Charts of the runs of one recipe in the order in which they were added. Every run except the
/// repeats has its place on the axis. Only accepted runs enter the statistics: what another run
/// measured is shown but does not count.
RunCharts run_charts(const std::string& recipe, const std::vector<HistoryRun>& runs);

/// For scripts/history_chart.py, with lengths in mm (docs/run_history.md).
std::string to_json(const RunCharts& charts);

}  // namespace part_recipes
