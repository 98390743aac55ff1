// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/made_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "history/made_runs.h"

namespace part_recipes {
namespace {

constexpr double kMillimetre = 1e-3;  // [m]

void refuse(RunRecord& record, bool has_figures) {
  record.state = RunState::kRefused;
  record.reason = has_figures ? "tolerance_exceeded" : "wrong_part";
  record.message = has_figures ? "a place is out of tolerance" : "another part lies here";
  if (has_figures) {
    record.figures.places["rim"] = 0.7 * kMillimetre;
  } else {
    record.figures = {};
  }
}

}  // namespace

std::vector<RunRecord> made_history(std::size_t count, const std::string& recipe) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto drawn = [&](double mean, double deviation) {
    return mean + deviation * normal(random);
  };
  std::vector<RunRecord> runs;
  for (std::size_t i = 0; i < count; ++i) {
    constexpr std::uint64_t kApart = 300, kSetBack = 3600;  // [s]
    RunRecord record = made_run(0, recipe);
    const std::uint64_t start = 86400 + kApart * i - (i >= 2 * count / 3 ? kSetBack : 0);
    record.started = time_after(start);
    record.ended = time_after(start + 4);
    record.id = fmt::format("{}_{:06x}", record.started.substr(0, 19), i);
    record.id.erase(std::remove_if(record.id.begin(), record.id.end(),
                                   [](char letter) { return letter == ':' || letter == '-'; }),
                    record.id.end());
    record.message = "the path was adapted";
    record.recipe_sha256 = i < count / 3 ? "first" : "second";
    const double share = static_cast<double>(i) / static_cast<double>(count);
    const double drift = std::max(0.0, share - 0.75) * 4 * 0.3 * kMillimetre;
    RunFigures& figures = record.figures;
    figures.scale = drawn(1.0123, 0.0002);
    figures.rms = std::abs(drawn(0.04, 0.004)) * kMillimetre;
    figures.largest_displacement = std::abs(drawn(3.1, 0.2)) * kMillimetre;
    figures.places = {{"left flank", drawn(0.02 * kMillimetre, 0.05 * kMillimetre) + drift},
                      {"right flank", drawn(-0.03 * kMillimetre, 0.05 * kMillimetre)},
                      {"rim", drawn(0, 0.05 * kMillimetre)}};
    constexpr std::size_t kRefusedEach = 12;
    if (i % kRefusedEach == kRefusedEach - 3) refuse(record, i % (2 * kRefusedEach) > kRefusedEach);
    runs.push_back(record);
  }
  return runs;
}

}  // namespace part_recipes
