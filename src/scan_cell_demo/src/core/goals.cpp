// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_demo/goals.h"

#include <sstream>

namespace scan_cell_demo {
namespace {

constexpr double kMostCloudRms = 0.3e-3;  // [m]
constexpr double kMostPathRms = 1.0e-3;   // [m]
constexpr double kLeastShareBound = 0.9;  // a busy computer drops some
constexpr double kMillimetres = 1e3;

std::string too_far(const std::string& what, double is, double most) {
  std::ostringstream text;
  text << what << " is off the truth by " << is * kMillimetres << " mm RMS; the goal is "
       << most * kMillimetres << " mm";
  return text.str();
}

}  // namespace

std::vector<std::string> missed_goals(const Figures& figures) {
  std::vector<std::string> missed;
  if (!(figures.cloud_rms <= kMostCloudRms)) {
    missed.push_back(too_far("a cloud", figures.cloud_rms, kMostCloudRms));
  }
  if (!(figures.path_rms <= kMostPathRms)) {
    missed.push_back(too_far("the path", figures.path_rms, kMostPathRms));
  }
  const std::string of_pulses = " of " + std::to_string(figures.pulses) + " pulses";
  const std::uint64_t known = figures.frames_bound + figures.frames_accounted_for;
  if (known < figures.pulses) {
    missed.push_back("nobody knows what became of " + std::to_string(figures.pulses - known) +
                     of_pulses);
  }
  if (static_cast<double>(figures.frames_bound) <
      kLeastShareBound * static_cast<double>(figures.pulses)) {
    missed.push_back("only " + std::to_string(figures.frames_bound) + of_pulses +
                     " gave a frame with a pose");
  }
  return missed;
}

}  // namespace scan_cell_demo
