// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "sequence/session_request.h"

#include <fmt/format.h>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {

using scan_cell_common::Refused;

namespace {

constexpr int kLasers = 2;  // lines of the trigger circuit

void check_exposure(const std::string& what, double exposure, const SessionLimits& limits) {
  if (exposure >= limits.min_exposure && exposure <= limits.max_exposure) return;
  throw Refused(what, fmt::format("{:g} s", exposure),
                fmt::format("give {:g} to {:g} s", limits.min_exposure, limits.max_exposure));
}

}  // namespace

std::vector<int> lasers_in(std::uint8_t mask) {
  std::vector<int> lasers;
  for (int laser = 0; laser < 8; ++laser) {
    if ((mask >> laser & 1) != 0) lasers.push_back(laser);
  }
  return lasers;
}

void check(const SessionRequest& request, const SessionLimits& limits) {
  if (request.poses.empty()) throw Refused("taught poses", "none", "teach at least one");
  const std::vector<int> lasers = lasers_in(request.lasers);
  if (!lasers.empty() && lasers.back() >= kLasers) {
    throw Refused("lasers", fmt::format("mask {}", request.lasers),
                  "give 1 (laser_0), 2 (laser_1), 3 (both, in turn) or 0 (the camera alone)");
  }
  check_exposure("exposure for the board", request.board_exposure, limits);
  check_exposure("exposure for the lines", request.line_exposure, limits);
}

}  // namespace scan_cell
