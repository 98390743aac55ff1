// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pass_correction.h"
#include "pass_overlap.h"

namespace laser_triangulation {

/// Whether the passes of a scan make one cloud. Values as in CloudStatistics.
enum class Agreement : std::uint8_t {
  kNotCompared = 0,  //!< a single sweep, or no two share enough of the surface
  kAgree = 1,        //!< as captured
  kMended = 2,       //!< after the correction
  kDisagree = 3,     //!< the cloud stays as captured
};

struct PassAgreement {
  Agreement agreement = Agreement::kNotCompared;
  std::string message;                       //!< for a person: the figures, and what to look at
  std::vector<Sweep> sweeps;                 //!< of the cloud
  std::vector<PassOverlap> overlaps;         //!< of the cloud as it is now
  std::optional<PassCorrection> correction;  //!< the one applied: one motion per sweep
};

/// Compares the sweeps, and corrects what the calibration's uncertainty explains.
/// @param deviations [m] of a scanned point, by laser: root of the sum of the calibration's
/// variances along x, y, z; empty: compare without correcting
PassAgreement bring_together(ScanCloud& cloud, const std::vector<double>& deviations);

}  // namespace laser_triangulation
