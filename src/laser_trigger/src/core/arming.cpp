// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "arming.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace laser_trigger {
namespace {

using scan_cell_common::Refused;

constexpr std::uint8_t kBoth = 3;  // mask

void check_lasers(const PulseGenerator::Arming& arming) {
  if ((arming.lasers & ~kBoth) != 0) {
    throw Refused("lasers", fmt::format("mask {}", arming.lasers),
                  "set only bit 0 (laser_0) and bit 1 (laser_1)");
  }
  if (!arming.alternate) return;
  if (arming.lasers != kBoth) {
    throw Refused("lasers", fmt::format("mask {} to alternate", arming.lasers),
                  "give mask 3: both lasers take turns");
  }
  if (!arming.pulses) {
    throw Refused("alternate", "without pulses",
                  "give a rate: the lasers take turns pulse by pulse");
  }
}

void check_rate(const PulseGenerator::Arming& arming, const PulseGenerator::Settings& settings) {
  constexpr double kMinRate = 0.1;  // [Hz] chosen
  const double most = std::min(settings.max_rate, 0.5 / settings.pulse_width);
  if (!(arming.rate >= kMinRate && arming.rate <= most)) {  // NaN too
    throw Refused("rate", fmt::format("{:g} Hz", arming.rate),
                  fmt::format("give a rate from {:g} to {:g} Hz", kMinRate, most));
  }
  // They change places half a period after the pulse, or when the exposure is over, if that is
  // later.
  const double exposure = exposure_of(arming, settings);
  const double turn = std::max(exposure, settings.laser_rise) + settings.laser_rise;
  if (arming.alternate && arming.rate * turn > 1) {
    constexpr double kMilliseconds = 1e3;
    throw Refused("rate", fmt::format("{:g} Hz to alternate", arming.rate),
                  fmt::format("give up to {:g} Hz: the exposure of {:g} ms and the laser's rise "
                              "time of {:g} ms must fit between two pulses",
                              std::floor(1 / turn), exposure * kMilliseconds,
                              settings.laser_rise * kMilliseconds));
  }
}

}  // namespace

void check(const PulseGenerator::Arming& arming, const PulseGenerator::Settings& settings) {
  if (!std::isfinite(arming.exposure) || arming.exposure < 0) {
    throw Refused("exposure", fmt::format("{:g} s", arming.exposure),
                  "give the camera's exposure, or 0 to use the trigger's parameter exposure");
  }
  if (arming.pulses) check_rate(arming, settings);
  check_lasers(arming);
  if (!std::isfinite(arming.longest_on) || arming.longest_on < 0) {
    throw Refused("longest_on", fmt::format("{:g} s", arming.longest_on),
                  "give a time above 0, or 0 to use the trigger's own limit");
  }
}

double exposure_of(const PulseGenerator::Arming& arming, const PulseGenerator::Settings& settings) {
  return arming.exposure > 0 ? arming.exposure + settings.exposure_delay : settings.exposure;
}

std::uint8_t lasers_of(const PulseGenerator::Arming& arming, std::uint64_t count) {
  if (!arming.alternate) return arming.lasers;
  return count % 2 == 1 ? 1 : 2;
}

int periods_after(const PulseGenerator::Arming& arming, std::uint64_t count) {
  return arming.alternate && count <= PulseGenerator::kSlowStart ? 2 : 1;
}

}  // namespace laser_trigger
