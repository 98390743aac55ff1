// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "plan/clearance.h"

#include <fmt/format.h>

#include "c4g_driver/flange_way.h"
#include "scan_cell/scan_run.h"

namespace pass_planner {

using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

/// The flange's way along the last pass and to its start.
/// @param start flange before the first pass
std::vector<Isometry3d> way_of_last(const std::vector<scan_cell::ScanPass>& passes,
                                    const Isometry3d& start) {
  std::vector<Isometry3d> way;
  Isometry3d at = start;
  for (const scan_cell::ScanRun& run : runs_of(passes)) {
    std::vector<scan_cell::MoveTarget> targets = run.moves;
    if (run.approach) targets.insert(targets.begin(), {run.start, std::nullopt});
    for (const scan_cell::MoveTarget& target : targets) {
      if (run.pass + 1 == passes.size()) {
        const auto motion = c4g_driver::flange_way(at, target.via, target.flange);
        way.insert(way.end(), motion.begin(), motion.end());
      }
      at = target.flange;
    }
  }
  return way;
}

}  // namespace

Clearance::Clearance(const scan_cell_common::ScannerModel& scanner, const Surface& surface,
                     const Reach& reach, const PlanParameters& parameters)
    : scanner_(scanner),
      surface_(surface),
      start_(reach.start()),
      to_world_(reach.frame_in_world()),
      clearance_(parameters.clearance),
      floor_height_(parameters.floor_height) {}

std::string Clearance::refusal(const std::vector<scan_cell::ScanPass>& passes) const {
  std::vector<std::pair<std::string, Vector3d>> bodies = {{"flange", Vector3d::Zero()}};
  bodies.emplace_back("camera", scanner_.flange_to_camera.translation());
  for (std::size_t i = 0; i < scanner_.lasers.size(); ++i) {
    if (!scanner_.lasers[i]) continue;
    bodies.emplace_back(scan_cell_common::laser_name(i),
                        scanner_.flange_to_camera * scanner_.lasers[i]->origin);
  }
  for (const Isometry3d& flange : way_of_last(passes, start_)) {
    for (const auto& [name, place] : bodies) {
      const Vector3d at = flange * place;
      const double distance =
          std::min((to_world_ * at).z() - floor_height_, surface_.nearest(at).distance);
      if (distance >= clearance_) continue;
      return fmt::format("{} comes within {:.0f} mm of the part or the floor", name,
                         1e3 * distance);
    }
  }
  return "";
}

}  // namespace pass_planner
