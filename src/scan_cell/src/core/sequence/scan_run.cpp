// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/scan_run.h"

#include <algorithm>

namespace scan_cell {
namespace {

constexpr std::uint8_t kLaser0 = 1;  // bits as in the trigger
constexpr std::uint8_t kLaser1 = 2;

std::vector<Lighting> lightings_of(PassLasers lasers) {
  switch (lasers) {
    case PassLasers::kLaser0:
      return {{kLaser0, false}};
    case PassLasers::kLaser1:
      return {{kLaser1, false}};
    case PassLasers::kEach:
      return {{kLaser0, false}, {kLaser1, false}};
    case PassLasers::kAlternate:
      return {{kLaser0 | kLaser1, true}};
  }
  return {};
}

std::vector<MoveTarget> moves_along(PassKind kind, const std::vector<Eigen::Isometry3d>& poses) {
  if (kind == PassKind::kArc) return {{poses[2], poses[1]}};
  std::vector<MoveTarget> moves;
  for (std::size_t i = 1; i < poses.size(); ++i)
    moves.push_back({poses[i], std::nullopt});
  return moves;
}

}  // namespace

std::vector<ScanRun> runs_of(const std::vector<ScanPass>& passes) {
  std::vector<ScanRun> runs;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    std::vector<Eigen::Isometry3d> poses = passes[i].poses;
    for (const Lighting& lighting : lightings_of(passes[i].lasers)) {
      const bool there = !runs.empty() && runs.back().moves.back().flange.isApprox(poses.front());
      runs.push_back({i, pass_name(passes[i], i), !there, poses.front(),
                      moves_along(passes[i].kind, poses), passes[i].speed, passes[i].rate, lighting,
                      passes[i].camera});
      std::reverse(poses.begin(), poses.end());
    }
  }
  return runs;
}

}  // namespace scan_cell
