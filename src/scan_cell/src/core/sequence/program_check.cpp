// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "sequence/program_check.h"

#include <fmt/format.h>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {
namespace {

/// The motions of a program, and for a person what each is.
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
  return fmt::format(" at {:.3f} {:.3f} {:.3f} m of its base", place->x(), place->y(), place->z());
}

}  // namespace

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
  throw scan_cell_common::Refused(program.names.at(check->possible),
                                  "the robot cannot go it" + text_of(check->place), check->refusal);
}

}  // namespace scan_cell
