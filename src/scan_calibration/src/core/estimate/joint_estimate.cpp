// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "estimate/joint_estimate.h"

#include <fmt/core.h>

#include <cmath>

#include "estimate/rejection.h"
#include "geometry/statistics.h"
#include "residuals/multiplicity.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

double change(const NoiseLevels& before, const NoiseLevels& after) {
  return (noise_vector(after).array() / noise_vector(before).array()).log().abs().maxCoeff();
}

Multiplicities multiplicities(const JointEstimate& estimate, const Observations& observations,
                              const BoardSurface& surface) {
  Multiplicities result;
  result.corners = corner_multiplicity(estimate.state, surface, observations.board, estimate.views);
  for (std::size_t laser = 0; laser < observations.lasers.size(); ++laser)
    result.lines.push_back(line_multiplicity(estimate.state, surface, estimate.views, laser));
  return result;
}

void check_majority(std::size_t before, const JointEstimate& estimate) {
  if (2 * estimate.views.size() > before) return;
  throw scan_cell_common::UnusableInput(
      "views of the session",
      fmt::format("{} do not fit the others; {}: {}", share(before - estimate.views.size(), before),
                  estimate.rejected.back().name, estimate.rejected.back().reason),
      "check the poses and the board's size, and that the board did not move");
}

}  // namespace

JointEstimate estimate_jointly(Start start, const Observations& observations,
                               const CalibrationOptions& options, const FitChoice& choice) {
  constexpr int kMaxRounds = 12;       // chosen: four are usual
  constexpr double kConverged = 0.02;  // relative change of the noise, chosen
  const BoardSurface surface(observations.board);
  const NoiseLevels given = given_noise(options, observations.lasers.size());
  const std::size_t before = start.views.size();
  JointEstimate estimate;
  estimate.views = std::move(start.views);
  estimate.state = std::move(start.state);
  estimate.noise.levels = start.noise;
  estimate.choice = choice;
  estimate.rejected = std::move(start.rejected);
  for (int round = 0; round < kMaxRounds; ++round) {
    estimate.multiplicities = multiplicities(estimate, observations, surface);
    weigh(estimate.state, surface, estimate.noise.levels, estimate.multiplicities, estimate.views);
    fit(estimate.views, surface, estimate.noise.levels, choice, estimate.state);
    const NormalEquations equations(estimate.views, surface, estimate.noise.levels, choice,
                                    estimate.state);
    const NoiseLevels assumed = estimate.noise.levels;
    estimate.noise = estimate_noise(equations, given);
    const bool left_out =
        reject_misfits(surface, estimate.noise.levels, equations, observations.lasers,
                       estimate.views, estimate.state, estimate.rejected);
    check_majority(before, estimate);
    check_lasers_seen(observations, estimate.views);
    if (!left_out && round > 0 && change(assumed, estimate.noise.levels) < kConverged) break;
  }
  fit(estimate.views, surface, estimate.noise.levels, choice, estimate.state);
  return estimate;
}

JointEstimate without(const JointEstimate& estimate, const BoardSurface& surface,
                      const std::vector<bool>& keep) {
  JointEstimate result = estimate;
  result.views.clear();
  result.state.corrections.clear();
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    result.views.push_back(estimate.views[i]);
    result.state.corrections.push_back(estimate.state.corrections[i]);
  }
  fit(result.views, surface, result.noise.levels, result.choice, result.state);
  return result;
}

}  // namespace scan_calibration
