// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "scan_cell_common/pose/timed_pose.h"

namespace c4g_driver {

/// How long something took, each time: counted in classes of an eighth of an octave (9 %), from 1
/// us to 16 s. Allocates nothing.
class Durations {
 public:
  using Nanoseconds = scan_cell_common::Nanoseconds;  //!< of the steady clock

  void add(Nanoseconds duration);  //!< allocates nothing

  std::uint64_t count() const { return count_; }  //!< of durations added

  /// What this share of them took at most: the upper end of a class; 0 of none.
  /// @param share from 0 to 1
  Nanoseconds quantile(double share) const;

  /// Those that came after `earlier`, a copy of this one.
  Durations since(const Durations& earlier) const;

 private:
  static constexpr int kClasses = 8 * 24;

  std::array<std::uint64_t, kClasses> classes_{};
  std::uint64_t count_ = 0;
};

}  // namespace c4g_driver
