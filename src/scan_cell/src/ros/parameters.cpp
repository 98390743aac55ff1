// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include <algorithm>

#include "scan_cell_common/ros/parameter_reader.h"

namespace scan_cell {

double Parameters::silence_allowed(double rate) const {
  constexpr double kPeriods = 5;
  constexpr double kLongest = 1.0;  // [s] a laser must be off two seconds after a device is lost
  return std::max(lost_after, std::min(kLongest, kPeriods / rate));
}

Parameters Parameters::load(const ros::NodeHandle& node) {
  scan_cell_common::ParameterReader reader(node);
  Parameters parameters;
  reader.read("base_frame", parameters.base_frame);
  reader.read("robot", parameters.robot);
  reader.read("camera", parameters.camera);
  reader.read("trigger", parameters.trigger);
  reader.read("binder", parameters.binder);
  reader.read("triangulation", parameters.triangulation);
  reader.read("lost_after", parameters.lost_after, {0.1, 1.0});
  reader.read("call_timeout", parameters.call_timeout, {0.1, 60});
  reader.read("most_speed", parameters.limits.most_speed, {0.001, 1.5});
  reader.read("most_rate", parameters.limits.most_rate, {0.1, 10000});
  reader.read("most_length", parameters.limits.most_length, {0.01, 10});
  reader.read("approach_speed", parameters.timing.approach_speed, {0.001, 1.5});
  reader.read("stall", parameters.timing.stall, {0.5, 60});
  reader.read("patience", parameters.timing.patience, {0.1, 60});
  reader.refuse_unknown();
  return parameters;
}

}  // namespace scan_cell
