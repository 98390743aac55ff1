// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "sequence/program_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {

using scan_cell_common::Refused;

namespace {

/// The motions of a program, and a description of each for a person.
struct ProgramMoves {
  std::vector<PlannedMove> moves;
  std::vector<std::string> names;

  void add(const std::string& name, const PlannedMove& move) {
    moves.push_back(move);
    names.push_back(name);
  }
};

std::string name_of(const ScanRun& run, std::size_t move) {
  const std::string way = run.moves[move].via ? "its arc" : "its line";
  if (run.moves.size() == 1) return fmt::format("{}, {}", run.name, way);
  return fmt::format("{}, {} {} of {}", run.name, way, move + 1, run.moves.size());
}

ProgramMoves moves_of(const std::vector<ScanRun>& runs, double approach_speed) {
  ProgramMoves program;
  for (const ScanRun& run : runs) {
    if (run.approach)
      program.add(run.name + ", the way to its start",
                  {{run.start, std::nullopt}, approach_speed, 0});
    for (std::size_t i = 0; i < run.moves.size(); ++i)
      program.add(name_of(run, i), {run.moves[i], run.speed, run.rate});
  }
  return program;
}

std::string text_of(const std::optional<Eigen::Vector3d>& place) {
  if (!place) return "";
  return fmt::format(" at {:.3f} {:.3f} {:.3f} m in its base frame", place->x(), place->y(),
                     place->z());
}

/// @throw Refused naming the pass and the place in it
std::vector<std::string> check_reach(Robot& robot, const std::vector<ScanRun>& runs,
                                     double approach_speed) {
  const ProgramMoves program = moves_of(runs, approach_speed);
  const std::optional<MovesCheck> check = robot.check(program.moves);
  if (!check) {
    return {
        "reach, singular postures and speeds of the joints were not checked before the first "
        "motion: the robot's driver has no service for it"};
  }
  if (check->refusal.empty()) return {};
  throw Refused(program.names.at(check->possible),
                "the robot cannot follow it" + text_of(check->place), check->refusal);
}

/// The names of the passes to which something applies, each once.
template <class Applies>
std::string passes_where(const std::vector<ScanRun>& runs, const Applies& applies) {
  std::vector<std::string> names;
  for (const ScanRun& run : runs) {
    if (applies(run) && (names.empty() || names.back() != run.name)) names.push_back(run.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

bool needs_exposure(const ScanRun& run) {
  return run.lighting.alternate && !run.camera.exposure;
}

/// Warnings about what only the camera knows.
std::vector<std::string> only_tried_by_a_scan(const std::vector<ScanRun>& runs) {
  std::vector<std::string> warnings;
  const auto add = [&](const std::string& what, const std::string& passes) {
    if (passes.empty()) return;
    warnings.push_back(what + " was not checked (" + passes +
                       "): a scan checks it, before it moves");
  };
  add("whether the camera accepts the settings of its pass",
      passes_where(runs, [](const ScanRun& run) { return !run.camera.empty(); }));
  add("whether the camera's exposure leaves the lasers time to take turns",
      passes_where(runs, needs_exposure));
  return warnings;
}

}  // namespace

std::vector<std::string> check_runs(const AskedBefore& asked, const std::vector<ScanRun>& runs,
                                    double approach_speed) {
  for (const ScanRun& run : runs)
    on(Outcome::kRefused, Outcome::kStageFailed, [&] { asked.stages.check_run(run); });
  return on(Outcome::kRefused, Outcome::kRobotLost,
            [&] { return check_reach(asked.robot, runs, approach_speed); });
}

std::string check_arming(Trigger& trigger, const ScanRun& run, double exposure) {
  Lighting lighting = run.lighting;
  lighting.exposure = exposure;
  const bool checked = on(Outcome::kRefused, Outcome::kTriggerLost, [&] {
    try {
      return trigger.check(run.rate, lighting);
    } catch (const Refused& refused) {
      throw Refused(run.name + ": trigger", "arming refused", refused.what());
    }
  });
  if (checked) return "";
  return "rates and lasers of the passes were not checked before the first motion: the trigger has "
         "no service for it";
}

std::vector<std::string> check_at_rest(const AskedBefore& asked, const std::vector<ScanRun>& runs,
                                       double approach_speed) {
  constexpr double kShortest = 1e-6;  // [s] no camera's exposure is shorter; chosen
  const std::string trouble = asked.robot.trouble();
  if (!trouble.empty()) throw EndEarly{Outcome::kRobotLost, trouble};
  std::vector<std::string> warnings = check_runs(asked, runs, approach_speed);
  std::string unchecked;
  for (const ScanRun& run : runs)
    unchecked = check_arming(asked.trigger, run, run.camera.exposure.value_or(kShortest));
  if (!unchecked.empty()) warnings.push_back(unchecked);
  for (const std::string& warning : only_tried_by_a_scan(runs))
    warnings.push_back(warning);
  return warnings;
}

}  // namespace scan_cell
