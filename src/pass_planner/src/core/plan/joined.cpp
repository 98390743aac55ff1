// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "plan/joined.h"

#include <fmt/format.h>

#include <algorithm>

namespace pass_planner {
namespace {

using scan_cell::PassLasers;
using scan_cell::ScanPass;

double apart(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.translation() - b.translation()).norm();
}

/// Takes the line with the end nearest to a pose, and turns it to begin there.
ScanPass take_nearest(const Eigen::Isometry3d& from, std::vector<ScanPass>& lines) {
  const auto distance = [&from](const ScanPass& line) {
    return std::min(apart(from, line.poses.front()), apart(from, line.poses.back()));
  };
  const auto nearest = std::min_element(
      lines.begin(), lines.end(),
      [&](const ScanPass& a, const ScanPass& b) { return distance(a) < distance(b); });
  ScanPass line = *nearest;
  lines.erase(nearest);
  if (apart(from, line.poses.back()) < apart(from, line.poses.front()))
    std::reverse(line.poses.begin(), line.poses.end());
  return line;
}

}  // namespace

ScanPass joined(std::vector<ScanPass> lines, double rate) {
  ScanPass pass = lines.front();
  lines.erase(lines.begin());
  if (lines.empty()) return pass;
  pass.name = fmt::format("{} lines, one after the other", lines.size() + 1);
  pass.kind = scan_cell::PassKind::kPolyline;
  while (!lines.empty()) {
    const ScanPass next = take_nearest(pass.poses.back(), lines);
    if (next.lasers != pass.lasers) pass.lasers = PassLasers::kAlternate;
    pass.poses.insert(pass.poses.end(), next.poses.begin(), next.poses.end());
  }
  pass.rate = pass.lasers == PassLasers::kAlternate ? 2 * rate : rate;
  return pass;
}

}  // namespace pass_planner
