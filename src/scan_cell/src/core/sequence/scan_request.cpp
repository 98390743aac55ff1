// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/scan_request.h"

#include <cmath>

#include "scan_cell_common/errors.h"

namespace scan_cell {
namespace {

using scan_cell_common::Refused;

void check_range(const std::string& name, double value, double most, const std::string& unit) {
  if (std::isfinite(value) && value > 0 && value <= most) return;
  throw Refused(name, std::to_string(value) + " " + unit,
                "give one above 0, up to " + std::to_string(most) + " " + unit);
}

void check_pose(const std::string& name, const Eigen::Isometry3d& pose) {
  if (pose.matrix().allFinite()) return;
  throw Refused(name, "not finite", "give a pose of finite numbers");
}

}  // namespace

void check(const ScanRequest& request, const ScanLimits& limits) {
  check_pose("start of the scan", request.start);
  check_pose("end of the scan", request.end);
  check_range("speed", request.speed, limits.most_speed, "m/s");
  check_range("frame rate", request.rate, limits.most_rate, "Hz");
  if (request.rate < limits.least_rate) {
    throw Refused("frame rate", std::to_string(request.rate) + " Hz",
                  "give at least " + std::to_string(limits.least_rate) +
                      " Hz: the loss of a slower camera would be noticed too late");
  }
  const double length = (request.end.translation() - request.start.translation()).norm();
  if (length < limits.least_length || length > limits.most_length) {
    throw Refused("length of the scan", std::to_string(length) + " m",
                  "give start and end from " + std::to_string(limits.least_length) + " to " +
                      std::to_string(limits.most_length) + " m apart");
  }
  if (request.lasers != 1 && request.lasers != 2) {
    throw Refused("lasers", std::to_string(request.lasers),
                  "give 1 for laser_0 or 2 for laser_1: a frame holds one line");
  }
}

}  // namespace scan_cell
