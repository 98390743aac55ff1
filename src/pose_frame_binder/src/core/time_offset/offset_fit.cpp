// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "time_offset/offset_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

namespace pose_frame_binder {
namespace {

/// The standard deviation of the residuals of pairs on slopes, or on flats, from their median.
double robust_deviation(const std::vector<OffsetPair>& pairs, bool on_relief,
                        const Eigen::Vector3d& solution) {
  constexpr double kOfMedian = 1.4826;  // normal noise: deviation over median absolute value
  constexpr double kLeast = 1e-6;       // [m] chosen
  std::vector<double> sizes;
  for (const OffsetPair& pair : pairs)
    if (pair.on_relief == on_relief)
      sizes.push_back(std::abs(pair.residual + pair.slope.dot(solution)));
  if (sizes.empty()) return kLeast;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return std::max(kLeast, kOfMedian * *middle);
}

struct Equations {
  Eigen::Matrix3d noise = Eigen::Matrix3d::Zero();  // of the information
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

/// Noisy normals seem to separate the delay from a shift even where the surface does not, so the
/// information due to their noise is subtracted (errors in variables).
double deviation_of_delay(const Equations& all, const Eigen::Matrix3d& prior) {
  Eigen::Matrix3d measured = all.information - prior;
  const double speed = std::sqrt(measured(0, 0) / (measured(1, 1) + measured(2, 2)));
  const Eigen::DiagonalMatrix<double, 3> to_metres(1 / speed, 1, 1);
  measured = to_metres * (measured - all.noise) * to_metres;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(measured);
  measured = axes.eigenvectors() * axes.eigenvalues().cwiseMax(0).asDiagonal() *
             axes.eigenvectors().transpose();
  const Eigen::Matrix3d information = measured + to_metres * prior * to_metres;
  return std::sqrt(information.inverse()(0, 0)) / speed;
}

/// How much the delay changes if one block of the scene is left out, over all blocks (jackknife):
/// pairs of a block share the errors of their patches and poses. These errors also reach across
/// blocks: the largest result of blocks one, two and three times as long counts.
double jackknife(const Equations& all, const std::map<int, Equations>& blocks) {
  double most = 0;
  for (const int length : {1, 2, 3}) {
    std::map<int, Equations> longer;
    for (const auto& [number, block] : blocks) {
      Equations& sum = longer[static_cast<int>(std::floor(static_cast<double>(number) / length))];
      sum.information += block.information;
      sum.gradient += block.gradient;
    }
    double squares = 0;
    for (const auto& [number, block] : longer) {
      const Eigen::Matrix3d rest = all.information - block.information;
      squares += std::pow((rest.inverse() * block.gradient)[0], 2);
    }
    const auto count = static_cast<double>(longer.size());
    most = std::max(most, std::sqrt(squares * (count - 1) / count));
  }
  return most;
}

}  // namespace

OffsetFit fit_offset(const std::vector<OffsetPair>& pairs) {
  constexpr int kSteps = 20;               // chosen
  constexpr double kTukey = 4.685;         // standard deviations: 95 % efficient for normal noise
  constexpr double kAlmostNothing = 1e-6;  // [1/s^2] about the delay: ensures an inverse; chosen
  constexpr double kShift = 1e-3;          // [m] expected offset across the motion; chosen
  const Eigen::Matrix3d prior =
      Eigen::Vector3d(kAlmostNothing, 1 / (kShift * kShift), 1 / (kShift * kShift)).asDiagonal();
  OffsetFit fit;
  for (int step = 0; step < kSteps; ++step) {
    // Separate, since the many flats would turn all slopes into outliers while the delay is far
    // off.
    const double of_flats = robust_deviation(pairs, false, fit.solution);
    const double of_slopes = std::max(of_flats, robust_deviation(pairs, true, fit.solution));
    Equations all;
    all.information = prior;
    all.gradient = prior * fit.solution;
    std::map<int, Equations> blocks;
    for (const OffsetPair& pair : pairs) {
      const double deviation = pair.on_relief ? of_slopes : of_flats;
      const double residual = pair.residual + pair.slope.dot(fit.solution);
      const double share = residual / (kTukey * deviation);
      if (std::abs(share) >= 1) continue;
      const double weight = std::pow(1 - share * share, 2) / (deviation * deviation);
      for (Equations* equations : {&all, &blocks[pair.block]}) {
        equations->information += weight * pair.slope * pair.slope.transpose();
        equations->gradient += weight * residual * pair.slope;
        equations->noise += weight * pair.slope_noise;
      }
    }
    fit.solution -= all.information.inverse() * all.gradient;
    fit.from_posterior = deviation_of_delay(all, prior);
    fit.from_residuals = jackknife(all, blocks);
  }
  return fit;
}

}  // namespace pose_frame_binder
