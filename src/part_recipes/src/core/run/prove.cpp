// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/prove.h"

#include <fmt/format.h>

#include <cmath>

#include "recipe/proof.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
namespace {

using scan_cell_common::Refused;

void check_within(const std::string& what, const std::optional<double>& deviation, double tolerance,
                  const std::string& run) {
  const std::string cure = "see " + run + "; calibrate the cell, or make the recipe again";
  if (!deviation) throw Refused(what, "not measured", cure);
  if (std::abs(*deviation) > tolerance) {
    throw Refused(what,
                  fmt::format("{:.3f} mm, tolerance {:.3f} mm", 1e3 * *deviation, 1e3 * tolerance),
                  cure);
  }
}

}  // namespace

EndedRun prove(const Recipe& recipe, RunRequest request, const StageBegins& begins) {
  request.prove = true;
  const Hashes files = hashes_of(recipe);
  EndedRun ended = run_recipe(recipe, request, begins);
  const RunRecord& record = ended.record;
  const std::string run = ended.folder.string();
  if (record.state != RunState::kAccepted)
    throw Refused("recipe '" + recipe.name + "'", to_string(record.state) + ": " + record.message,
                  "see " + run);
  check_within("RMS deviation of the reference part", record.figures.deviation_rms,
               recipe.tolerance, run);
  for (const auto& [name, deviation] : record.figures.places)
    check_within("deviation at '" + name + "'", deviation, recipe.tolerance, run);
  save_proof(recipe, {true, record.ended, record.id, files, record.calibration});
  return ended;
}

}  // namespace part_recipes
