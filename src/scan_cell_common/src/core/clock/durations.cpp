// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/clock/durations.h"

#include <algorithm>
#include <cmath>

namespace scan_cell_common {
namespace {

constexpr double kLeast = 1e3;     // [ns] chosen
constexpr double kInAnOctave = 8;  // classes; chosen

}  // namespace

void Durations::add(Nanoseconds duration) {
  const double octaves = std::log2(std::max(kLeast, static_cast<double>(duration)) / kLeast);
  const int number = std::clamp(static_cast<int>(kInAnOctave * octaves), 0, kClasses - 1);
  ++classes_[static_cast<std::size_t>(number)];
  ++count_;
}

Nanoseconds Durations::quantile(double share) const {
  if (count_ == 0) return 0;
  const auto wanted =
      std::max<std::uint64_t>(1, std::llround(std::ceil(share * static_cast<double>(count_))));
  std::uint64_t reached = 0;
  std::size_t number = 0;
  while (number + 1 < classes_.size() && (reached += classes_[number]) < wanted)
    ++number;
  return std::llround(kLeast * std::exp2((static_cast<double>(number) + 1) / kInAnOctave));
}

Durations Durations::since(const Durations& earlier) const {
  Durations later = *this;
  later.count_ -= earlier.count_;
  for (std::size_t i = 0; i < classes_.size(); ++i)
    later.classes_[i] -= earlier.classes_[i];
  return later;
}

}  // namespace scan_cell_common
