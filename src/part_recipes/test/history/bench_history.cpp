// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Times the listing, filtering and charting of a history of many runs, beside reading the run.json
// files of the same runs. With --make it leaves such a history behind.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>

#include "history/chart/run_chart.h"
#include "history/export/aqdef.h"
#include "history/export/history_csv.h"
#include "history/history.h"
#include "history/made_history.h"
#include "history/made_runs.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

namespace fs = std::filesystem;

using part_recipes::History;
using part_recipes::HistoryFilter;
using part_recipes::RunRecord;
using Clock = std::chrono::steady_clock;

constexpr const char* kRecipe = "photo frame";
constexpr int kRepeats = 5;  // the median of them

double seconds_of(const std::function<void()>& work) {
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double median_of(const std::function<void()>& work) {
  std::vector<double> all;
  for (int i = 0; i < kRepeats; ++i)
    all.push_back(seconds_of(work));
  std::sort(all.begin(), all.end());
  return all[kRepeats / 2];
}

void write_all(const fs::path& folder, const std::vector<RunRecord>& runs) {
  for (const RunRecord& run : runs)
    part_recipes::write_run(folder, run);
}

std::size_t read_all(const fs::path& folder, const std::vector<RunRecord>& runs) {
  std::size_t keys = 0;
  for (const RunRecord& run : runs) {
    const std::string file = (folder / run.id / part_recipes::kRunFile).string();
    keys += nlohmann::json::parse(scan_cell_common::read_file(file)).size();
  }
  return keys;
}

void print(const char* what, double seconds, double yardstick) {
  std::printf("%-44s %8.3f s %8.2f\n", what, seconds, seconds / yardstick);
}

void bench(std::size_t count) {
  const part_recipes::TemporaryFolder folder;
  const auto runs = part_recipes::made_history(count, kRecipe);
  write_all(folder.path(), runs);
  const History history(folder.path());
  const double yardstick = median_of([&] { read_all(folder.path(), runs); });
  std::printf("%zu runs; goal: less than 1 s for list, filter and chart-data\n%-44s %10s %8s\n",
              count, "", "", "times");
  print("every run.json read with nlohmann::json", yardstick, yardstick);
  print("rebuild", seconds_of([&] { history.rebuild(); }), yardstick);
  print("list all", median_of([&] { history.query({}); }), yardstick);
  HistoryFilter filter;
  filter.recipe = kRecipe;
  filter.state = "refused";
  filter.since = "2026-01-10";
  filter.text = "another part";
  print("filter by recipe, state, start and text", median_of([&] { history.query(filter); }),
        yardstick);
  filter = {};
  filter.recipe = kRecipe;
  print("chart-data",
        median_of([&] { to_json(part_recipes::run_charts(kRecipe, history.query(filter))); }),
        yardstick);
  print("csv", median_of([&] { part_recipes::to_csv(history.query({})); }), yardstick);
  print("aqdef", median_of([&] { part_recipes::to_aqdef(history.query({})); }), yardstick);
  print("runs that the history does not have", median_of([&] { history.left_out(); }), yardstick);
  RunRecord one = part_recipes::made_run(1);
  const fs::path added = part_recipes::write_run(folder.path(), one);
  print("add one", seconds_of([&] { history.add(added); }), yardstick);
}

/// Makes a history and leaves it.
void make(const fs::path& folder, std::size_t count) {
  fs::create_directories(folder);
  for (const RunRecord& run : part_recipes::made_history(count, kRecipe))
    History(folder).add(part_recipes::write_run(folder, run));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the history of runs beside reading their run.json files");
  std::size_t count = 10000;
  std::string folder;
  app.add_option("--count", count, "of runs")->check(CLI::Range(2, 1000000))->capture_default_str();
  app.add_option("--make", folder, "makes such runs and their history there and ends");
  return scan_cell_common::tool_main("bench_history", app, argc, argv, [&] {
    if (folder.empty()) {
      bench(count);
    } else {
      make(folder, count);
    }
    return 0;
  });
}
