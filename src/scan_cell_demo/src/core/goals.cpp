// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "core/goals.h"

#include <fmt/format.h>

#include "scan_cell_common/pose/units.h"

namespace scan_cell_demo {
namespace {

constexpr double kMinShareBound = 0.9;  // a busy computer drops some
using scan_cell_common::kMillimetres;

/// Adds a sentence if a distance exceeds its limit or is unknown.
void check_distance(const std::string& what, const std::string& mean, double distance, double most,
                    std::vector<std::string>& missed) {
  if (distance <= most) return;
  missed.push_back(fmt::format("{} {:g} mm {}off the ground truth; the goal is {:g} mm", what,
                               distance * kMillimetres, mean, most * kMillimetres));
}

}  // namespace

std::vector<std::string> missed_goals(const Figures& figures, const Goals& goals) {
  std::vector<std::string> missed;
  check_distance("a cloud is", "RMS ", figures.cloud_rms, goals.cloud_rms, missed);
  check_distance("the path is", "RMS ", figures.path_rms, goals.path_rms, missed);
  check_distance("the farthest waypoint is", "", figures.path_max, goals.path_max, missed);
  if (figures.worked) {
    check_distance("the tool's tip went", "RMS ", figures.tip_rms, goals.tip_rms, missed);
    check_distance("at the farthest waypoint the tip went", "", figures.tip_max, goals.tip_max,
                   missed);
  }
  const std::uint64_t known = figures.frames_bound + figures.frames_accounted_for;
  if (known < figures.pulses) {
    missed.push_back(fmt::format("{} of {} pulses are not accounted for", figures.pulses - known,
                                 figures.pulses));
  }
  if (static_cast<double>(figures.frames_bound) <
      kMinShareBound * static_cast<double>(figures.pulses)) {
    missed.push_back(fmt::format("only {} of {} pulses gave a frame with a pose",
                                 figures.frames_bound, figures.pulses));
  }
  return missed;
}

}  // namespace scan_cell_demo
