// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tecnogamma_camera/counter_unwrapper.h"

namespace tecnogamma_camera {

CounterStep CounterUnwrapper::unwrap(std::uint64_t raw) {
  using Kind = CounterStep::Kind;
  if (raw < rule_.first || raw > rule_.last) return {Kind::kInvalid};
  if (!started_) {
    started_ = true;
    last_raw_ = last_count_ = raw;
    return {Kind::kFirst, raw};
  }
  if (raw == last_raw_) return {Kind::kRepeated, last_count_};

  const std::uint64_t period = rule_.last - rule_.first + 1;
  const std::uint64_t forward = raw > last_raw_ ? raw - last_raw_ : raw + period - last_raw_;
  if (forward > period / 2) {
    const std::uint64_t back = period - forward;
    return {Kind::kBackward, last_count_ > back ? last_count_ - back : 0};
  }
  last_raw_ = raw;
  last_count_ += forward;
  return {forward == 1 ? Kind::kNext : Kind::kGap, last_count_, forward - 1};
}

}  // namespace tecnogamma_camera
