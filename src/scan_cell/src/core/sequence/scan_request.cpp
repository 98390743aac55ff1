// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/scan_request.h"

#include <fmt/format.h>

#include <cmath>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {
namespace {

using scan_cell_common::Refused;

void check_range(const std::string& name, double value, double most, const std::string& unit) {
  if (std::isfinite(value) && value > 0 && value <= most) return;
  throw Refused(name, fmt::format("{:g} {}", value, unit),
                fmt::format("give one above 0, up to {:g} {}", most, unit));
}

void check_pose(const std::string& name, const Eigen::Isometry3d& pose) {
  if (pose.matrix().allFinite()) return;
  throw Refused(name, "not finite", "give a pose of finite numbers");
}

}  // namespace

void check(const ScanRequest& request, const ScanLimits& limits) {
  check_pose("start of the scan", request.start);
  check_pose("end of the scan", request.end);
  check_range("speed", request.speed, limits.max_speed, "m/s");
  check_range("frame rate", request.rate, limits.max_rate, "Hz");
  if (request.rate < limits.min_rate) {
    throw Refused(
        "frame rate", fmt::format("{:g} Hz", request.rate),
        fmt::format("give at least {:g} Hz: the loss of a slower camera would be noticed too late",
                    limits.min_rate));
  }
  const double length = (request.end.translation() - request.start.translation()).norm();
  if (length < limits.min_length || length > limits.max_length) {
    throw Refused("length of the scan", fmt::format("{:g} m", length),
                  fmt::format("give start and end from {:g} to {:g} m apart", limits.min_length,
                              limits.max_length));
  }
  if (request.lasers != 1 && request.lasers != 2) {
    throw Refused("lasers", fmt::format("{}", request.lasers),
                  "give 1 for laser_0 or 2 for laser_1: a frame holds one line");
  }
}

}  // namespace scan_cell
