// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "plan/clearance.h"

#include <fmt/format.h>

#include "c4g_driver/flange_way.h"

namespace pass_planner {

using Eigen::Isometry3d;
using Eigen::Vector3d;

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
  const Isometry3d from = passes.size() > 1 ? passes[passes.size() - 2].poses.back() : start_;
  std::vector<Isometry3d> way =
      c4g_driver::flange_way(from, std::nullopt, passes.back().poses.front());
  for (const Isometry3d& flange : sweeps_of({passes.back()}).front().flange)
    way.push_back(flange);
  for (const Isometry3d& flange : way) {
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
