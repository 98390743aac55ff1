// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Disturbs the simulated cell at random times during moves and scans, and while the tool follows a
// path: emergency stop, cable pulled, controller, driver, cell or videe_node killed; or cancels a
// scan of three passes. Reports how long lasers and tool stayed on, and which promises were broken.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <random>

#include "running_cell/started_cell.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/tools/tool_main.h"
#include "trials/trial.h"

using namespace scan_cell_demo;  // NOLINT

namespace {

constexpr std::uint16_t kTapPort = 15420;  // trials.launch
constexpr std::uint16_t kCircuitPort = 5420;
constexpr std::uint16_t kVideePort = 15421;  // trials.launch
constexpr double kMilliseconds = 1e3;

struct Options {
  int count = 200;
  unsigned seed = 1;
  TrialLimits limits;
  std::string folder = "out/trials";
  std::vector<std::string> blows;
  std::vector<std::string> moments;
};

/// @param round of this blow, counted
Moment moment_of(Blow blow, int round) {
  const std::vector<Blow>& in_a_path = every_blow_in_a_path();
  const bool may_be = std::count(in_a_path.begin(), in_a_path.end(), blow) > 0;
  if (may_be && round % 3 == 2) return Moment::kMidPath;
  return round % (may_be ? 3 : 2) == 0 ? Moment::kMidScan : Moment::kMidMove;
}

/// All kinds in equal numbers, in an order set by the seed.
/// @throw scan_cell_common::InvalidParameter if no blow is possible at any of the moments
std::vector<Trial> mix(const Options& options) {
  std::mt19937 random(options.seed);
  std::uniform_real_distribution<double> share(0.1, 0.7), pause(0, 2),
      anywhere(0, 0.97);  // a scan slower than the first must not end before the blow
  std::vector<Blow> wanted;
  for (const Blow blow : every_blow()) {
    if (std::count(options.blows.begin(), options.blows.end(), name_of(blow)) > 0)
      wanted.push_back(blow);
  }
  std::vector<Trial> trials;
  constexpr int kRounds = 6;  // by then each blow came at each of its moments
  for (int i = 0; static_cast<int>(trials.size()) < options.count; ++i) {
    if (trials.empty() && i > kRounds * static_cast<int>(wanted.size()))
      throw scan_cell_common::InvalidParameter("--moments",
                                               fmt::format("{}", fmt::join(options.moments, ", ")),
                                               "give one at which these blows can come");
    const auto blows = static_cast<int>(wanted.size());
    const Blow blow = wanted[static_cast<std::size_t>(i % blows)];
    Moment moment = moment_of(blow, i / blows);
    double part = share(random);
    if (blow == Blow::kStop && moment != Moment::kMidPath) {
      moment = Moment::kMidProgram;
      part = anywhere(random);
    }
    const Trial trial{blow, moment, part, pause(random)};
    if (std::count(options.moments.begin(), options.moments.end(), name_of(moment)) > 0)
      trials.push_back(trial);
  }
  std::shuffle(trials.begin(), trials.end(), random);
  return trials;
}

/// Results of all trials of one kind.
struct Tally {
  std::vector<double> on;      // [s]
  std::vector<double> moving;  // [s]
  int trials = 0;
  int broken = 0;
};

TrialResult make_safely(TrialBench& bench, const Trial& trial, const std::string& name) {
  try {
    return bench.make(trial, name);
  } catch (const scan_cell_common::Error& error) {
    return {std::nullopt, std::nullopt, "", "", {error.what()}};
  }
}

/// [ms] from times [s]; - if nothing was measured
std::string median_and_max(std::vector<double> times) {
  if (times.empty()) return "-";
  std::sort(times.begin(), times.end());
  return fmt::format("{:.1f}, {:.1f}", kMilliseconds * times[times.size() / 2],
                     kMilliseconds * times.back());
}

void print(const std::map<std::string, Tally>& tallies, const TrialLimits& limits) {
  std::printf(
      "\nlasers, or the tool, on after the blow [ms], goal: %.0f; on a path still moving, goal: "
      "%.0f\n%-36s %6s %16s %16s %8s\n",
      kMilliseconds * limits.on, kMilliseconds * limits.moving, "", "trials", "on: median, max",
      "moving: the same", "broken");
  for (const auto& [kind, tally] : tallies) {
    std::printf("%-36s %6d %16s %16s %8d\n", kind.c_str(), tally.trials,
                median_and_max(tally.on).c_str(), median_and_max(tally.moving).c_str(),
                tally.broken);
  }
}

int run(const Options& options) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::absolute(options.folder);
  const fs::path clouds = folder / "clouds";
  fs::remove_all(clouds);
  fs::create_directories(clouds);
  const StartedCell started("trials", {LAUNCH_FILE, "folder:=" + clouds.string()}, folder);
  const LaserTap tap(kTapPort, kCircuitPort);
  RunningCell cell{ros::NodeHandle()};
  cell.wait_until_well();  // otherwise no trial would be meaningful
  TrialBench bench(cell, tap, clouds, kVideePort, options.limits);
  std::map<std::string, Tally> tallies;
  int broken = 0, number = 0;
  for (const Trial& trial : mix(options)) {
    const TrialResult result = make_safely(bench, trial, fmt::format("trial_{}", ++number));
    const std::string kind = name_of(trial.blow) + ", " + name_of(trial.moment);
    Tally& tally = tallies[kind];
    ++tally.trials;
    if (result.on) tally.on.push_back(*result.on);
    if (result.moving) tally.moving.push_back(*result.moving);
    if (!result.failures.empty()) ++tally.broken, ++broken;
    std::printf("%d of %d: %s at %.0f %% (%s): on for %s ms; %s\n", number, options.count,
                kind.c_str(), 100 * trial.share, result.place.c_str(),
                result.on ? fmt::format("{:.1f}", kMilliseconds * *result.on).c_str() : "-",
                result.outcome.c_str());
    for (const std::string& failure : result.failures)
      std::printf("  BROKEN: %s\n", failure.c_str());
    std::fflush(stdout);
  }
  print(tallies, options.limits);
  std::printf("%d of %d trials broke a promise; %d scans ended by themselves before the blow\n",
              broken, options.count, bench.begun_anew());
  return broken == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  for (const Blow blow : every_blow())
    options.blows.push_back(name_of(blow));
  for (const Moment moment :
       {Moment::kMidMove, Moment::kMidScan, Moment::kMidProgram, Moment::kMidPath})
    options.moments.push_back(name_of(moment));
  CLI::App app("Disturbs the simulated cell at random times, and checks its promises");
  app.add_option("--count", options.count, "number of trials")->check(CLI::PositiveNumber);
  app.add_option("--seed", options.seed, "seed of their order and times");
  app.add_option("--max-on", options.limits.on,
                 "seconds that lasers, or the tool, may be on after a blow");
  app.add_option("--max-moving", options.limits.moving,
                 "seconds that the robot may still move after a blow in a path");
  scan_cell_common::refuse_renamed(app, {{"--most-on", "--max-on"}});
  app.add_option("--blows", options.blows, "disturbances to choose from")
      ->check(CLI::IsMember(options.blows))
      ->capture_default_str();
  app.add_option("--moments", options.moments, "when they may come")
      ->check(CLI::IsMember(options.moments))
      ->capture_default_str();
  app.add_option("--folder", options.folder, "folder for clouds and logs");
  return scan_cell_common::tool_main("trials", app, argc, argv, [&] { return run(options); });
}
