// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_planner/sweep.h"

#include <iterator>

#include "c4g_driver/flange_way.h"
#include "scan_cell_common/errors/errors.h"

namespace pass_planner {
namespace {

using Eigen::Isometry3d;
using scan_cell::PassKind;
using scan_cell::PassLasers;
using scan_cell::ScanPass;

std::vector<std::size_t> lasers_of(PassLasers lasers) {
  if (lasers == PassLasers::kLaser0) return {0};
  if (lasers == PassLasers::kLaser1) return {1};
  return {0, 1};
}

std::vector<Isometry3d> way_of(const ScanPass& pass) {
  if (pass.kind == PassKind::kArc)
    return c4g_driver::flange_way(pass.poses[0], pass.poses[1], pass.poses[2]);
  std::vector<Isometry3d> way = {pass.poses.front()};
  for (std::size_t i = 1; i < pass.poses.size(); ++i) {
    const auto line = c4g_driver::flange_way(pass.poses[i - 1], std::nullopt, pass.poses[i]);
    way.insert(way.end(), std::next(line.begin()), line.end());
  }
  return way;
}

}  // namespace

std::vector<Sweep> sweeps_of(const std::vector<ScanPass>& passes) {
  std::vector<Sweep> sweeps;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    try {
      const std::vector<Isometry3d> way = way_of(passes[i]);
      for (const std::size_t laser : lasers_of(passes[i].lasers))
        sweeps.push_back({i, laser, way, passes[i].camera.region});
    } catch (const scan_cell_common::Refused& error) {
      throw scan_cell_common::Refused(pass_name(passes[i], i) + ": " + error.thing(), error.value(),
                                      error.cure());
    }
  }
  return sweeps;
}

}  // namespace pass_planner
