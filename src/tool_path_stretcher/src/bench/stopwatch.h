// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <ctime>

namespace bench {

/// [s] wall-clock time; only differences have a meaning
inline double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// [s] processor time of this program, over all processors
inline double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// [s] wall-clock time of some work; nothing else should run meanwhile
template <class Work>
double seconds_of(Work work) {
  const double start = wall_seconds();
  work();
  return wall_seconds() - start;
}

}  // namespace bench
