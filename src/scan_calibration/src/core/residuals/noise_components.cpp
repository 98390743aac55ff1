// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "residuals/noise_components.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scan_calibration {
namespace {

struct Component {
  double squares = 0;  // over the noise assumed
  double count = 0;
  double redundancy = 0;
};

/// Squares of each group after a step to the minimum, and its redundancy.
std::vector<Component> components(const NormalEquations& equations, const ReducedSystem& system) {
  std::vector<Component> result(equations.views.front().size());
  const Eigen::VectorXd shared = -system.covariance * system.gradient;
  for (std::size_t v = 0; v < equations.views.size(); ++v) {
    const ReducedView& reduced = system.views[v];
    Eigen::VectorXd step(6 + shared.size());
    step << -reduced.own - reduced.coupling * shared, shared;
    const Eigen::MatrixXd covariance = joint_covariance(reduced, system.covariance);
    for (std::size_t group = 0; group < result.size(); ++group) {
      const GroupSquares& part = equations.views[v][group];
      const double factor = system.factors[static_cast<Eigen::Index>(group)];
      result[group].squares +=
          factor * (part.squares + 2 * part.gradient.dot(step) + step.dot(part.matrix * step));
      result[group].count += part.count;
      result[group].redundancy += part.count - factor * part.matrix.cwiseProduct(covariance).sum();
    }
  }
  return result;
}

}  // namespace

NoiseLevels given_noise(const CalibrationOptions& options, std::size_t lasers) {
  return {options.corner_deviation, std::vector<double>(lasers, options.line_deviation),
          options.robot_deviation, options.robot_angle_deviation};
}

NoiseLevels min_noise(std::size_t lasers) {
  constexpr double kPixels = 1e-4;   // [px] chosen: far below any detector's noise
  constexpr double kMetres = 1e-5;   // [m] chosen: no robot is better
  constexpr double kRadians = 1e-5;  // [rad] chosen: no robot is better
  return {kPixels, std::vector<double>(lasers, kPixels), kMetres, kRadians};
}

NoiseEstimate estimate_noise(const NormalEquations& equations, const NoiseLevels& given) {
  constexpr int kMaxSteps = 200;           // chosen: tens are usual
  constexpr double kConverged = 1e-3;      // relative change of a deviation, chosen
  constexpr double kMinRedundancy = 1e-3;  // of a group's count, chosen: less says nothing
  const Eigen::VectorXd known = noise_vector(given);
  const Eigen::VectorXd least = noise_vector(min_noise(given.line_px.size()));
  NoiseEstimate result;
  Eigen::VectorXd noise = equations.noise;
  for (Eigen::Index group = 0; group < known.size(); ++group)
    if (known[group] > 0) noise[group] = known[group];
  for (int step = 0; step < kMaxSteps; ++step) {
    const std::vector<Component> parts = components(equations, ReducedSystem(equations, noise));
    result.freedom.setConstant(known.size(), std::numeric_limits<double>::infinity());
    double change = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto group = static_cast<Eigen::Index>(i);
      if (known[group] > 0 || !(parts[i].count > 0)) continue;
      result.freedom[group] = std::max(parts[i].redundancy, kMinRedundancy * parts[i].count);
      const double next = std::max(
          noise[group] * std::sqrt(parts[i].squares / result.freedom[group]), least[group]);
      change = std::max(change, std::abs(next / noise[group] - 1));
      noise[group] = next;
    }
    if (change < kConverged) break;
  }
  result.levels = noise_levels(noise);
  return result;
}

}  // namespace scan_calibration
