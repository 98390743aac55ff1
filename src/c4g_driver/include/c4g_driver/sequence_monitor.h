// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bitset>
#include <cstdint>

namespace c4g_driver {

/// What the numbers of a stream tell about the wire.
struct SequenceCounts {
  std::uint64_t received = 0;
  std::uint64_t lost = 0;
  std::uint64_t repeated = 0;
  std::uint64_t reordered = 0;  //!< came after a later one
};

/// Watches the numbers of a stream that starts at 1.
class SequenceMonitor {
 public:
  enum class Verdict { Next, Repeated, Late };

  Verdict take(std::uint64_t number);

  /// The stream starts anew; the counts go on.
  void restart();

  const SequenceCounts& counts() const { return counts_; }

 private:
  static constexpr std::uint64_t kMemory = 256;

  std::uint64_t newest_ = 0;
  std::bitset<kMemory> seen_;  // bit i: number newest_ - i was received
  SequenceCounts counts_;
};

}  // namespace c4g_driver
