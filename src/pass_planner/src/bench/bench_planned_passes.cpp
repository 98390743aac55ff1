// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>

#include "cures.h"
#include "scan_cell_common/tools/tool_main.h"

int main(int argc, char** argv) {
  CLI::App app(
      "How many refusals for a missing scan the one proposed pass cures, in the simulator");
  int refusals = 20;
  std::uint64_t seed = 1000;
  app.add_option("--refusals", refusals, "how many to wait for")->capture_default_str();
  app.add_option("--seed", seed, "of the first part")->capture_default_str();
  return scan_cell_common::tool_main("bench_planned_passes", app, argc, argv, [&] {
    const pass_planner::CellFiles files = {SCANNER_FILE, CELL_FILE, URDF_FILE};
    int found = 0, cured = 0, drawn = 0;
    for (; found < refusals; ++seed, ++drawn) {
      const auto trial = pass_planner::run_cure(files, seed);
      std::printf("%4lu %-14s %s\n", seed, trial.part.c_str(), trial.first_verdict.c_str());
      std::fflush(stdout);
      if (!trial.not_scanned) continue;
      ++found;
      cured += trial.cured;
      std::printf("     %zu of %zu waypoints missing; %s: %s %s\n", trial.missing, trial.waypoints,
                  trial.pass.empty() ? "no pass" : trial.pass.c_str(),
                  trial.cured ? "cured" : trial.second_verdict.c_str(), trial.why.c_str());
      if (trial.passes > 1) std::printf("     %zu passes would see all\n", trial.passes);
      std::fflush(stdout);
    }
    std::printf(
        "%d parts, %d refused with path_not_scanned, %d cured by the one proposed pass "
        "(goal: 95 %%)\n",
        drawn, found, cured);
    return 0;
  });
}
