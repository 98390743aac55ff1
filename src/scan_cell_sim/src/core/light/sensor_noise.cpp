// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "light/sensor_noise.h"

#include <cstring>
#include <random>

#include "scene/scramble.h"

namespace scan_cell_sim {
namespace {

constexpr std::size_t kSamples = 1U << 18U;  // stored twice: a row may begin anywhere; chosen

std::size_t place(std::uint64_t seed, int row, std::uint64_t kind) {
  return scramble(seed + 2 * static_cast<std::uint64_t>(row) + kind) % kSamples;
}

}  // namespace

SensorNoise::SensorNoise(const Optics& optics) : dark_(2 * kSamples), light_(2 * kSamples) {
  std::mt19937_64 random(scramble(optics.seed));
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < kSamples; ++i) {
    light_[i] = light_[i + kSamples] = static_cast<float>(normal(random));
    dark_[i] = dark_[i + kSamples] = to_grey(optics.background + optics.read_noise * light_[i]);
  }
}

void SensorNoise::fill_dark(std::uint64_t seed, int width, int height, std::uint8_t* pixels) const {
  const auto length = static_cast<std::size_t>(width);
  for (int row = 0; row < height; ++row) {
    std::memcpy(pixels + static_cast<std::size_t>(row) * length, &dark_[place(seed, row, 0)],
                length);
  }
}

const float* SensorNoise::light(std::uint64_t seed, int row) const {
  return &light_[place(seed, row, 1)];
}

}  // namespace scan_cell_sim
