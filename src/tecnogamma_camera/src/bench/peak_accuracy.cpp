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

constexpr int kTrialColumns = 256;  // [px] chosen, as what follows
constexpr double kMiddle = 128;     // [px]
constexpr int kPhases = 20;         // of a pixel
constexpr int kRowsOfPhase = 500;   // [px]
constexpr double kHeight = 120;     // [grey value]
constexpr double kMost = 255;       // [grey value] in 8 bits

/// Integral over a pixel of the stripe's profile, height 1.
double pixel_of(double offset, double sigma) {
  const auto integral = [&](double column) {
    return sigma * std::sqrt(M_PI / 2) * std::erf(column / (sigma * M_SQRT2));
  };
  return integral(offset + 0.5) - integral(offset - 0.5);
}

double position_of(int row) {
  return kMiddle + static_cast<double>(row % kPhases) / kPhases;
}

/// One stripe per row, over all sub-pixel phases.
std::vector<std::uint8_t> stripes(double sigma, const StripeLight& light) {
  std::mt19937 engine(1);
  std::normal_distribution<double> normal;
  std::vector<std::uint8_t> pixels;
  pixels.reserve(static_cast<std::size_t>(kTrialColumns) * kPhases * kRowsOfPhase);
  for (int row = 0; row < kPhases * kRowsOfPhase; ++row) {
    for (int column = 0; column < kTrialColumns; ++column) {
      const double line = light.height * pixel_of(column - position_of(row), sigma);
      const double noise = std::hypot(light.noise, light.shot * std::sqrt(line));
      const double grey = light.background + line + noise * normal(engine);
      pixels.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(grey, 0.0, kMost))));
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

Accuracy measure(const PeakProfile& profile, double sigma, const StripeLight& light) {
  Accuracy result;
  double squares = 0, information = 0;
  std::vector<double> sums(kPhases), counts(kPhases);
  for (int row = 0; row < profile.rows(); ++row) {
    const double truth = position_of(row);
    information += std::pow(cramer_rao_bound(truth, sigma, light), 2);
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

/// @param figure that tells the stripes of a table apart
void print_stripe(const PeakDetector& detector, double sigma, const StripeLight& light,
                  double figure) {
  const auto pixels = stripes(sigma, light);
  PeakProfile profile;
  detector.detect(
      ImageView8{pixels.data(), kTrialColumns, kPhases * kRowsOfPhase, kTrialColumns, 0, 0},
      profile);
  const Accuracy found = measure(profile, sigma, light);
  std::printf("  %5.1f %8.0f %9.4f %9.4f %7.2f %9.4f %9.2f\n", sigma, figure, found.rms,
              found.bound, found.rms / found.bound, found.bias,
              100.0 * found.missing / profile.rows());
}

void print_head(const char* figure, const char* unit) {
  std::printf("  sigma %8s  rms error     bound   ratio  greatest  without\n", figure);
  std::printf("   [px] %8s       [px]      [px]          bias [px] peak [%%]\n", unit);
}

void print_in_white_noise(const PeakDetector& detector) {
  print_head("height/", "noise");
  for (const double sigma : {0.7, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0}) {
    for (const double ratio : {5.0, 10.0, 20.0, 50.0, 100.0}) {
      const double noise = kHeight / ratio;  // on a background on which no pixel falls below zero
      print_stripe(detector, sigma, {kHeight, 10 + 3 * noise, noise, 0}, ratio);
    }
  }
}

void print_as_in_the_simulator(const PeakDetector& detector) {
  constexpr double kBackground = 6, kReadNoise = 1.2, kShotNoise = 0.35;  // its defaults
  std::printf("the same in the simulated camera's noise, up to saturation at %.0f\n", kMost);
  print_head("height", "[grey]");
  for (const double sigma : {1.0, 2.0, 3.0, 4.0, 6.0})
    for (const double height : {60.0, 120.0, 220.0, 300.0, 1000.0})
      print_stripe(detector, sigma, {height, kBackground, kReadNoise, kShotNoise}, height);
}

}  // namespace

double cramer_rao_bound(double position, double sigma, const StripeLight& light) {
  const auto profile = [&](double column) {
    return std::exp(-0.5 * std::pow((column - position) / sigma, 2));
  };
  constexpr double kReach = 8;  // sigmas; beyond, the profile is below 1e-13
  const int reach = static_cast<int>(std::ceil(kReach * sigma)) + 1;
  const int middle = static_cast<int>(std::lround(position));
  double information = 0;
  for (int column = middle - reach; column <= middle + reach; ++column) {
    const double line = light.height * pixel_of(column - position, sigma);
    if (light.background + line >= kMost) continue;
    const double variance = light.noise * light.noise + light.shot * light.shot * line + 1.0 / 12;
    information +=
        std::pow(light.height * (profile(column + 0.5) - profile(column - 0.5)), 2) / variance;
  }
  return 1 / std::sqrt(information);
}

void print_peak_accuracy() {
  for (const std::string& name : detector_names()) {
    const auto detector = make_detector(name, {});
    std::printf("%s, Gaussian stripes %.0f grey values high, 8 bit, automatic trigger level\n",
                name.c_str(), kHeight);
    print_in_white_noise(*detector);
    print_as_in_the_simulator(*detector);
  }
}

}  // namespace tecnogamma_camera
