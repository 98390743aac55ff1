// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bitset>
#include <cstdint>

#include "c4g_driver/link_report.h"

namespace c4g_driver {

/// Watches the numbers of a stream that starts at 1.
class SequenceMonitor {
 public:
  enum class Verdict { kNext, kRepeated, kLate };

  Verdict take(std::uint64_t number);

  /// The stream starts anew; the counts go on.
  void restart();

  const SequenceCounts& counts() const { return counts_; }

 private:
  static constexpr std::uint64_t kMemory = 256;  // numbers; half a second at 500 Hz; chosen

  std::uint64_t newest_ = 0;
  std::bitset<kMemory> seen_;  // bit i: number newest_ - i was received
  SequenceCounts counts_;
};

}  // namespace c4g_driver
