// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "clock/utc_time.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>

namespace part_recipes {
namespace {

using std::chrono::system_clock;

std::tm utc(system_clock::time_point time) {
  return fmt::gmtime(system_clock::to_time_t(time));
}

}  // namespace

std::string utc_now() {
  using std::chrono::milliseconds;
  const auto now = system_clock::now();
  const auto part = std::chrono::duration_cast<milliseconds>(now.time_since_epoch()).count() % 1000;
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", utc(now), part);
}

std::string utc_stamp() {
  return fmt::format("{:%Y%m%dT%H%M%SZ}", utc(system_clock::now()));
}

}  // namespace part_recipes
