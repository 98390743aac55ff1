// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scan_cell_sim/exposure.h"

namespace scan_cell_sim {

/// A grey value that a pixel can hold.
template <class Number>
std::uint8_t to_grey(Number value) {
  return static_cast<std::uint8_t>(std::clamp(value + Number(0.5), Number(0), Number(255)));
}

/// The noise of the sensor's pixels. It is drawn once, and read from places that a frame's seed
/// chooses: the same seed gives the same noise.
class SensorNoise {
 public:
  explicit SensorNoise(const Optics& optics);

  /// Fills `pixels` (width x height, row by row) with the dark level and its read noise.
  void fill_dark(std::uint64_t seed, int width, int height, std::uint8_t* pixels) const;

  /// Standard normal values for the shot noise of a row, as many as it has pixels.
  const float* light(std::uint64_t seed, int row) const;

 private:
  std::vector<std::uint8_t> dark_;
  std::vector<float> light_;
};

}  // namespace scan_cell_sim
