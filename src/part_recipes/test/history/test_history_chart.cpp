// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "history/chart/run_chart.h"
#include "history/made_runs.h"

namespace part_recipes {
namespace {

using Json = nlohmann::json;

std::vector<HistoryRun> numbered(const std::vector<RunRecord>& records) {
  std::vector<HistoryRun> runs;
  for (const RunRecord& record : records)
    runs.push_back({static_cast<std::int64_t>(runs.size()) + 1, record});
  return runs;
}

/// Accepted runs with these deviations at the one place "rim" [m].
std::vector<RunRecord> runs_with(const std::vector<double>& deviations) {
  std::vector<RunRecord> records;
  for (const double deviation : deviations) {
    records.push_back(made_run(records.size()));
    records.back().figures.places = {{"rim", deviation}};
  }
  return records;
}

/// Values that alternate on either side of 0 by a tenth of a millimetre.
std::vector<double> calm_metres(std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = i % 2 == 0 ? -0.0001 : 0.0001;
  return values;
}

Json data_of(const std::vector<RunRecord>& records) {
  return Json::parse(to_json(run_charts("frame", numbered(records))));
}

Json chart_of(const std::vector<RunRecord>& records, const std::string& name) {
  const Json data = data_of(records);
  for (const Json& chart : data.at("charts")) {
    if (chart.at("name") == name) return chart;
  }
  return nullptr;
}

// NIST e-Handbook 6.3.2.2, as deviations of micrometres
TEST(RunChart, HasTheLimitsOfTheNistFlowRatesInMillimetres) {
  std::vector<double> flow = {49.6, 47.6, 49.9, 51.3, 47.8, 51.2, 52.6, 52.4, 53.6, 52.1};
  for (double& value : flow)
    value *= 1e-3;  // [m]
  const Json limits = chart_of(runs_with(flow), "rim").at("limits");
  EXPECT_NEAR(limits.at("mean"), 50.81, 1e-9);
  EXPECT_NEAR(limits.at("upper"), 55.8041, 5e-5);
  EXPECT_NEAR(limits.at("lower"), 45.8159, 5e-5);
  EXPECT_EQ(limits.at("count"), 10);
  EXPECT_EQ(limits.at("moving_ranges").size(), 9u);
  EXPECT_EQ(limits.at("moving_ranges").at(0).at(0), 2);
  EXPECT_NEAR(limits.at("moving_ranges").at(0).at(1), 2, 1e-9);
}

TEST(RunChart, ShowsRefusedRunsAtTheirPlaceAndDoesNotCountThem) {
  auto records = runs_with(calm_metres(30));
  records[10].state = RunState::kRefused;
  records[10].reason = "tolerance_exceeded";
  records[10].figures.places["rim"] = 0.9;
  records[20].state = RunState::kUnusable;
  records[20].reason = "scan";
  records[20].figures = {};
  const Json data = data_of(records);
  EXPECT_EQ(data.at("runs").size(), 30u);
  EXPECT_EQ(data.at("runs").at(10).at("state"), "refused");
  EXPECT_EQ(data.at("refusals"), (Json{{"tolerance_exceeded", 1}, {"scan", 1}}));
  const Json chart = chart_of(records, "rim");
  EXPECT_EQ(chart.at("values").at(10), 900);
  EXPECT_TRUE(chart.at("values").at(20).is_null());
  EXPECT_EQ(chart.at("limits").at("count"), 28);
  EXPECT_EQ(chart.at("limits").at("moving_ranges").at(9).at(0), 12);  // over the gap
}

TEST(RunChart, NamesTheRunsThatBreakARule) {
  auto values = calm_metres(40);
  values[30] = 0.0007;
  auto records = runs_with(values);
  records[5].state = RunState::kRefused;  // the axis has it, the statistics do not
  const Json breaks = chart_of(records, "rim").at("rule_breaks");
  ASSERT_EQ(breaks.size(), 1u);
  EXPECT_EQ(breaks[0], (Json{{"rule", 1}, {"at", 31}, {"points", {31}}}));
}

TEST(RunChart, GivesACapabilityOfPlacesWithTheirTolerance) {
  const Json chart = chart_of(runs_with(calm_metres(26)), "rim");
  // Closed form: 26 values of +- 0.1 mm, standard deviation 0.1 sqrt(26 / 25), limits +- 0.5 mm
  EXPECT_NEAR(chart.at("capability").at("cp"), 1 / (6 * 0.1 * std::sqrt(26.0 / 25)), 1e-9);
  EXPECT_EQ(chart.at("capability").at("cpk"), chart.at("capability").at("cp"));
  EXPECT_EQ(chart.at("capability").at("from"), 1);
  EXPECT_EQ(chart.at("tolerance"), (Json{-0.5, 0.5}));
  EXPECT_EQ(chart_of(runs_with(calm_metres(26)), "rms").at("capability").at("none"),
            "no_tolerance");
}

TEST(RunChart, SaysWhyThereIsNoCapability) {
  const auto why = [](const std::vector<RunRecord>& records) {
    return chart_of(records, "rim").at("capability").at("none").get<std::string>();
  };
  EXPECT_EQ(why(runs_with(calm_metres(24))), "too_few_values");
  auto records = runs_with(calm_metres(40));
  records[3].tolerance = 0.001;
  EXPECT_EQ(why(records), "tolerance_changed");
  for (RunRecord& record : records)
    record.tolerance = 0;
  EXPECT_EQ(why(records), "no_tolerance");
  records = runs_with(calm_metres(40));
  for (RunRecord& record : records)
    record.state = RunState::kRefused;
  EXPECT_EQ(why(records), "too_few_values");
}

TEST(RunChart, TellsWhereTheClockWentBackAndWhereTheRecipeChanged) {
  auto records = runs_with(calm_metres(4));
  records[2].started = time_after(0);
  records[3].started = time_after(1);
  records[3].recipe_sha256 = "other";
  const Json runs = data_of(records).at("runs");
  std::vector<bool> back, changed;
  for (const Json& run : runs) {
    back.push_back(run.at("time_went_back"));
    changed.push_back(run.at("recipe_changed"));
  }
  EXPECT_EQ(back, (std::vector<bool>{false, false, true, false}));
  EXPECT_EQ(changed, (std::vector<bool>{false, false, false, true}));
}

TEST(RunChart, LeavesRepeatsOutAndTellsTheirNumber) {
  auto records = runs_with(calm_metres(4));
  records[3].again_of = records[0].id;
  const Json data = data_of(records);
  EXPECT_EQ(data.at("runs").size(), 3u);
  EXPECT_EQ(data.at("repeats_left_out"), 1);
}

TEST(RunChart, HasNoLimitBelowZeroWhereNothingCanBe) {
  std::vector<RunRecord> records = runs_with(calm_metres(3));
  const std::vector<double> rms = {0.00001, 0.0001, 0.00001};
  for (std::size_t i = 0; i < rms.size(); ++i)
    records[i].figures.rms = rms[i];
  EXPECT_TRUE(chart_of(records, "rms").at("limits").at("lower").is_null());
  EXPECT_FALSE(chart_of(records, "rim").at("limits").at("lower").is_null());
}

TEST(RunChart, OfOneRunHasNoLimits) {
  EXPECT_TRUE(chart_of(runs_with({0.001}), "rim").at("limits").is_null());
}

}  // namespace
}  // namespace part_recipes
