// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/sequence_monitor.h"

namespace c4g_driver {

SequenceMonitor::Verdict SequenceMonitor::take(std::uint64_t number) {
  ++counts_.received;
  if (number > newest_) {
    const std::uint64_t step = number - newest_;
    counts_.lost += step - 1;
    seen_ = step < kMemory ? seen_ << step : std::bitset<kMemory>();
    seen_.set(0);
    newest_ = number;
    return Verdict::kNext;
  }
  const std::uint64_t age = newest_ - number;
  if (age >= kMemory || seen_.test(age)) {
    ++counts_.repeated;
    return Verdict::kRepeated;
  }
  seen_.set(age);
  ++counts_.reordered;
  if (counts_.lost > 0) --counts_.lost;  // it was counted as lost when the later one arrived
  return Verdict::kLate;
}

void SequenceMonitor::restart() {
  newest_ = 0;
  seen_.reset();
}

}  // namespace c4g_driver
