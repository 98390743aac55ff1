// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/colours/colour_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace scan_cell_common {
namespace {

constexpr Rgb kGrey = {0.6F, 0.6F, 0.6F};
constexpr Rgb kPurple = {0.80F, 0.47F, 0.65F};  // Okabe and Ito 2008
constexpr std::array<Rgb, 5> kBrightening = {{{0.27F, 0.00F, 0.33F},
                                              {0.23F, 0.32F, 0.55F},
                                              {0.13F, 0.57F, 0.55F},
                                              {0.37F, 0.79F, 0.38F},
                                              {0.99F, 0.91F, 0.14F}}};
// The same as in the pages of runs, part_recipes/scripts/report/colours.py.
constexpr std::array<unsigned, 7> kDiverging = {0x0b4fa8, 0x3d8fe0, 0xa6cdf2, 0xf4f4f4,
                                                0xfcc98f, 0xee8a1d, 0xb04f00};

Rgb from_hex(unsigned colour) {
  constexpr float kMost = 255;
  return {static_cast<float>(colour >> 16U) / kMost,
          static_cast<float>(colour >> 8U & 0xFFU) / kMost,
          static_cast<float>(colour & 0xFFU) / kMost};
}

/// @param place of 0 .. the last stop
template <class Stop>
Rgb between(double place, std::size_t last, const Stop& stop) {
  const double within = std::clamp(place, 0.0, static_cast<double>(last));
  const auto lower = std::min(static_cast<std::size_t>(within), last - 1);
  const auto part = static_cast<float>(within - static_cast<double>(lower));
  const Rgb from = stop(lower), to = stop(lower + 1);
  Rgb colour{};
  for (std::size_t i = 0; i < colour.size(); ++i)
    colour[i] = (1 - part) * from[i] + part * to[i];
  return colour;
}

}  // namespace

Rgb brightening(double share) {
  if (std::isnan(share)) return kGrey;
  constexpr std::size_t kLast = kBrightening.size() - 1;
  return between(share * kLast, kLast, [](std::size_t i) { return kBrightening[i]; });
}

Rgb diverging(double share) {
  if (std::isnan(share)) return kPurple;
  constexpr std::size_t kLast = kDiverging.size() - 1;
  return between((share + 1) / 2 * kLast, kLast,
                 [](std::size_t i) { return from_hex(kDiverging[i]); });
}

}  // namespace scan_cell_common
