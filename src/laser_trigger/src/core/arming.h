// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laser_trigger/pulse_generator.h"

namespace laser_trigger {

/// @throw scan_cell_common::Refused if rate, lasers or longest_on are invalid, or leave alternating
/// lasers too little time
void check(const PulseGenerator::Arming& arming, const PulseGenerator::Settings& settings);

/// [s] after a pulse during which alternating lasers do not change.
double exposure_of(const PulseGenerator::Arming& arming, const PulseGenerator::Settings& settings);

/// Mask of the lasers that are on with the pulse of this count (from 1).
std::uint8_t lasers_of(const PulseGenerator::Arming& arming, std::uint64_t count);

/// Periods from the deadline of the pulse of this count to the deadline of the next.
int periods_after(const PulseGenerator::Arming& arming, std::uint64_t count);

}  // namespace laser_trigger
