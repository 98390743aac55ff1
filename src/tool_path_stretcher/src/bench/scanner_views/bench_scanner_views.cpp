// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>

#include "scan_cell_common/tools/tool_main.h"
#include "scanner_views/case_list.h"
#include "scanner_views/figures/view_table.h"
#include "scanner_views/view_files.h"

namespace {

using namespace scanner_views;

struct Options {
  std::uint64_t seed = 1;
  std::string cases;
  std::string json;
  std::string folder;
  std::size_t yardsticks_every = 6;
  bool only_ours = false;
};

std::vector<ViewCase> chosen_cases(const Options& options) {
  const char* const data = std::getenv("SCAN_CELL_DATA");
  if (data == nullptr)
    std::printf("Without the real parts: SCAN_CELL_DATA does not name a folder with parts/\n\n");
  std::vector<ViewCase> chosen;
  for (ViewCase& each : all_cases(options.seed, data == nullptr ? "" : data)) {
    if ((each.family + ": " + each.name()).find(options.cases) != std::string::npos)
      chosen.push_back(std::move(each));
  }
  return chosen;
}

CaseResult result_of(const ViewCase& each, bool with_others) {
  const View view = view_of(each);
  const auto outcome = [&](Answer (*run)(const View&)) {
    const bool cleaned = view.not_cleaned.empty();
    return outcome_of(
        cleaned ? run(view) : Answer{false, "not_cleaned", view.not_cleaned, {}, {}, 0}, each,
        view);
  };
  CaseResult result;
  result.family = each.family;
  result.name = each.name();
  result.to_accept = each.expected == Reason::kAccepted;
  result.points = view.object.places.size();
  result.ours = outcome(run_ours);
  if (!with_others) return result;
  for (Answer (*const run)(const View&) : {run_thesis, run_pcl, run_open3d})
    result.others.push_back(outcome(run));
  return result;
}

void print_all(const Options& options) {
  std::printf("### What a line scanner sees, seed %llu\n\n",
              static_cast<unsigned long long>(options.seed));
  std::vector<CaseResult> results;
  const std::vector<ViewCase> chosen = chosen_cases(options);
  print_head(!options.only_ours);
  for (const ViewCase& each : chosen) {
    const bool with_others = !options.only_ours && results.size() % options.yardsticks_every == 0;
    results.push_back(result_of(each, with_others));
    print_line(results.back());
  }
  print_sums(results);
  if (!options.json.empty()) save_json(options.json, options.seed, results);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Figures of the stretcher on parts as a line scanner sees them.");
  Options options;
  app.add_option("--seed", options.seed, "draws other dimensions, poses, views and paths");
  app.add_option("--cases", options.cases, "only the cases whose family and name contain this");
  app.add_option("--yardsticks-every", options.yardsticks_every,
                 "run them in one of so many cases: they take several times as long as the rest")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--only-ours", options.only_ours, "without the yardsticks");
  app.add_option("--json", options.json, "write all figures here as well");
  app.add_option("--write", options.folder, "write the files of the first such case here instead");
  return scan_cell_common::tool_main("bench_scanner_views", app, argc, argv, [&] {
    if (options.folder.empty()) {
      print_all(options);
      return 0;
    }
    const std::vector<ViewCase> chosen = chosen_cases(options);
    if (chosen.empty()) return 1;
    write_files(view_of(chosen.front()), options.folder);
    return 0;
  });
}
