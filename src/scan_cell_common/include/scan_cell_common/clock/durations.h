// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "scan_cell_common/pose/timed_pose.h"

namespace scan_cell_common {

/// Histogram of durations, in classes of an eighth of an octave (9 %), from 1 us to 16 s. Allocates
/// nothing.
class Durations {
 public:
  void add(Nanoseconds duration);  //!< allocates nothing

  std::uint64_t count() const { return count_; }  //!< number of durations added

  /// The duration that this share of them did not exceed: the upper end of a class; 0 if there are
  /// none.
  /// @param share from 0 to 1
  Nanoseconds quantile(double share) const;

  /// The durations added since `earlier`, an older copy of this object.
  Durations since(const Durations& earlier) const;

 private:
  static constexpr int kClasses = 8 * 24;

  std::array<std::uint64_t, kClasses> classes_{};
  std::uint64_t count_ = 0;
};

}  // namespace scan_cell_common
