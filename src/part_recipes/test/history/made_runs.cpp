// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/made_runs.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

#include "scan_cell_common/files/files.h"

namespace part_recipes {

namespace fs = std::filesystem;

std::string time_after(std::uint64_t seconds) {
  constexpr std::time_t kStart = 1767225600;  // [s] 2026-01-01T00:00:00Z since 1970
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.000Z",
                     fmt::gmtime(kStart + static_cast<std::time_t>(seconds)));
}

RunRecord made_run(std::uint64_t number, const std::string& recipe) {
  constexpr double kMicrometre = 1e-6;  // [m]
  RunRecord record;
  record.id = fmt::format("run_{:06}", number);
  record.recipe_name = recipe;
  record.recipe_folder = "/recipes/" + recipe;
  record.recipe_sha256 = "0123";
  record.started = time_after(number);
  record.ended = time_after(number + 1);
  record.host = "cell-7";
  record.version = "0.1.0";
  record.state = RunState::kAccepted;
  record.reason = "accepted";
  record.message = fmt::format("message {}", number);
  record.tolerance = 0.0005;
  record.scan_units = "m";
  record.figures.scale = 1 + kMicrometre * static_cast<double>(number);
  record.figures.rms = kMicrometre * static_cast<double>(number);
  record.figures.largest_displacement = 0.003;
  record.figures.places = {{"left", kMicrometre * static_cast<double>(number)},
                           {"right", -kMicrometre * static_cast<double>(number)},
                           {"rim", std::nullopt}};
  return record;
}

fs::path write_run(const fs::path& runs, const RunRecord& record) {
  const fs::path partial = runs / ("." + record.id);
  fs::create_directories(partial);
  scan_cell_common::save_text((partial / kRunFile).string(), to_json(record));
  fs::rename(partial, runs / record.id);
  return runs / record.id;
}

}  // namespace part_recipes
