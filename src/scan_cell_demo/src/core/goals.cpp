// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "core/goals.h"

#include <fmt/format.h>

namespace scan_cell_demo {
namespace {

constexpr double kMaxCloudRms = 0.3e-3;  // [m]
constexpr double kMaxPathRms = 1.0e-3;   // [m]
constexpr double kMinShareBound = 0.9;   // a busy computer drops some
constexpr double kMillimetres = 1e3;

std::string too_far(const std::string& what, double rms, double max) {
  return fmt::format("{} is {:g} mm RMS off the ground truth; the goal is {:g} mm", what,
                     rms * kMillimetres, max * kMillimetres);
}

}  // namespace

std::vector<std::string> missed_goals(const Figures& figures) {
  std::vector<std::string> missed;
  if (!(figures.cloud_rms <= kMaxCloudRms)) {
    missed.push_back(too_far("a cloud", figures.cloud_rms, kMaxCloudRms));
  }
  if (!(figures.path_rms <= kMaxPathRms)) {
    missed.push_back(too_far("the path", figures.path_rms, kMaxPathRms));
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
