// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace scanner_views {

/// Random numbers that are the same on every machine; the standard library's distributions are not.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_(seed) {}

  /// Uniform between two values.
  double between(double least, double most) {
    return least + (most - least) * std::ldexp(static_cast<double>(engine_() >> 11U), -53);
  }

  /// Standard normal (Box and Muller 1958).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - between(0, 1)));
    return radius * std::cos(between(0, 2 * M_PI));
  }

  /// One of 0 .. count - 1.
  std::size_t one_of(std::size_t count) { return engine_() % count; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace scanner_views
