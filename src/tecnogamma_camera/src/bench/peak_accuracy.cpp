// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "peak_accuracy.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "tecnogamma_camera/peak_detector.h"

namespace tecnogamma_camera {
namespace {

constexpr int kColumns = 256;      // [px] chosen, as what follows
constexpr double kMiddle = 128;    // [px]
constexpr int kPhases = 20;        // of a pixel
constexpr int kRowsOfPhase = 500;  // [px]
constexpr double kHeight = 120;    // [grey value]

/// Integral of the stripe's profile, height 1, up to a column.
double integral(double column, double sigma) {
  return sigma * std::sqrt(M_PI / 2) * std::erf(column / (sigma * M_SQRT2));
}

double position_of(int row) {
  return kMiddle + static_cast<double>(row % kPhases) / kPhases;
}

/// One stripe per row, over all sub-pixel phases, in white noise on a background high enough that
/// no pixel falls below zero.
std::vector<std::uint8_t> stripes(double sigma, double noise) {
  std::mt19937 engine(1);
  std::normal_distribution<double> light(10 + 3 * noise, noise);
  std::vector<std::uint8_t> pixels;
  pixels.reserve(static_cast<std::size_t>(kColumns) * kPhases * kRowsOfPhase);
  for (int row = 0; row < kPhases * kRowsOfPhase; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const double offset = column - position_of(row);
      const double line = integral(offset + 0.5, sigma) - integral(offset - 0.5, sigma);
      const double grey = std::clamp(light(engine) + kHeight * line, 0.0, 255.0);
      pixels.push_back(static_cast<std::uint8_t>(std::lround(grey)));
    }
  }
  return pixels;
}

struct Accuracy {
  double rms = 0;    // [px]
  double bound = 0;  // [px]
  double bias = 0;   // [px] greatest of the mean errors at one phase
  int missing = 0;   // rows without a peak
};

Accuracy measure(const PeakProfile& profile, double sigma, double noise) {
  Accuracy result;
  double squares = 0, information = 0;
  std::vector<double> sums(kPhases), counts(kPhases);
  for (int row = 0; row < profile.rows(); ++row) {
    const double truth = position_of(row);
    information += std::pow(cramer_rao_bound(truth, sigma, kHeight, noise), 2);
    if (std::isnan(profile.position[row])) {
      ++result.missing;
      continue;
    }
    const double error = profile.position[row] - truth;
    squares += error * error;
    sums[row % kPhases] += error;
    counts[row % kPhases] += 1;
  }
  for (int phase = 0; phase < kPhases; ++phase)
    result.bias = std::max(result.bias, std::abs(sums[phase] / std::max(1.0, counts[phase])));
  result.rms = std::sqrt(squares / std::max(1, profile.rows() - result.missing));
  result.bound = std::sqrt(information / profile.rows());
  return result;
}

void print_stripe(const PeakDetector& detector, double sigma) {
  for (const double ratio : {5.0, 10.0, 20.0, 50.0, 100.0}) {
    const double noise = kHeight / ratio;
    const auto pixels = stripes(sigma, noise);
    PeakProfile profile;
    detector.detect(ImageView8{pixels.data(), kColumns, kPhases * kRowsOfPhase, kColumns, 0, 0},
                    profile);
    const Accuracy found = measure(profile, sigma, noise);
    std::printf("  %5.1f %8.0f %9.4f %9.4f %7.2f %9.4f %9.2f\n", sigma, ratio, found.rms,
                found.bound, found.rms / found.bound, found.bias,
                100.0 * found.missing / profile.rows());
  }
}

}  // namespace

double cramer_rao_bound(double position, double sigma, double height, double noise) {
  const auto profile = [&](double column) {
    return std::exp(-0.5 * std::pow((column - position) / sigma, 2));
  };
  constexpr double kReach = 8;  // sigmas; beyond, the profile is below 1e-13
  const int reach = static_cast<int>(std::ceil(kReach * sigma)) + 1;
  const int middle = static_cast<int>(std::lround(position));
  double information = 0;
  for (int column = middle - reach; column <= middle + reach; ++column)
    information += std::pow(height * (profile(column + 0.5) - profile(column - 0.5)), 2);
  return std::sqrt((noise * noise + 1.0 / 12) / information);
}

void print_peak_accuracy() {
  for (const std::string& name : detector_names()) {
    const auto detector = make_detector(name, {});
    std::printf("%s, Gaussian stripes %.0f grey values high, 8 bit, automatic trigger level\n",
                name.c_str(), kHeight);
    std::printf("  sigma  height/  rms error     bound   ratio  greatest  without\n");
    std::printf("   [px]    noise       [px]      [px]          bias [px] peak [%%]\n");
    for (const double sigma : {0.7, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0})
      print_stripe(*detector, sigma);
  }
}

}  // namespace tecnogamma_camera
