// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

namespace scan_cell_common {

/// Time in nanoseconds, on the clock that the context names. A double of seconds since 1970
/// resolves only 0.2 us and does not compare exactly.
using Nanoseconds = std::int64_t;

/// Nanoseconds to seconds.
constexpr double to_seconds(Nanoseconds time) {
  return static_cast<double>(time) * 1e-9;
}

/// Nearest nanosecond.
constexpr Nanoseconds from_seconds(double seconds) {
  return static_cast<Nanoseconds>(seconds * 1e9 + (seconds < 0 ? -0.5 : 0.5));
}

/// A measured pose and its time.
struct TimedPose {
  Nanoseconds time = 0;                                    //!< of the measurement
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< [m]

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

/// Pose at `fraction` of the way from `from` (0) to `to` (1): translation along the line, rotation
/// along the shortest arc at constant speed (Shoemake 1985).
Eigen::Isometry3d interpolate(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to,
                              double fraction);

/// Pose at `time`, which must be between the two (ends included).
/// @throw Refused if it is not: poses are never extrapolated.
Eigen::Isometry3d interpolate(const TimedPose& before, const TimedPose& after, Nanoseconds time);

}  // namespace scan_cell_common
