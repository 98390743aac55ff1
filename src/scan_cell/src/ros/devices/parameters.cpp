// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "devices/parameters.h"

#include <algorithm>

#include "scan_cell_common/ros/parameter_reader.h"

namespace scan_cell {

double Parameters::silence_allowed(double rate) const {
  constexpr double kPeriods = 5;
  constexpr double kLongest = 1.0;  // [s] a laser must be off two seconds after a device is lost
  return std::max(lost_after, std::min(kLongest, kPeriods / rate));
}

namespace {

void load_session(scan_cell_common::ParameterReader& reader, SessionSequence::Timing& session) {
  reader.read("calibration/speed", session.speed, {0.001, 1.5});
  reader.read("calibration/settle", session.settle, {0, 60});
  reader.read("calibration/still_position", session.still_position, {1e-6, 0.01});
  reader.read("calibration/still_angle", session.still_angle, {1e-6, 0.1});
  reader.read("calibration/still_patience", session.still_patience, {0.1, 60});
  reader.read("calibration/rate", session.rate, {2, 100});
  reader.read("calibration/image_patience", session.image_patience, {0.1, 60});
}

/// No limit where the parameter is not set.
void load_limits(scan_cell_common::ParameterReader& reader,
                 scan_calibration::CalibrationLimits& limits) {
  constexpr scan_cell_common::ParameterReader::Range kAny{1e-6, 1e6};
  reader.read("calibration/most_reprojection_rms_px", limits.reprojection_rms_px, kAny);
  reader.read("calibration/most_laser_plane_rms_mm", limits.laser_plane_rms_mm, kAny);
  reader.read("calibration/most_board_scatter_mm", limits.board_scatter_mm, kAny);
  reader.read("calibration/most_point_deviation_mm", limits.point_deviation_mm, kAny);
}

}  // namespace

Parameters Parameters::load(const ros::NodeHandle& node) {
  scan_cell_common::ParameterReader reader(node);
  Parameters parameters;
  reader.read("base_frame", parameters.base_frame);
  reader.read("flange_frame", parameters.flange_frame);
  reader.read("robot", parameters.robot);
  reader.read("camera", parameters.camera);
  reader.read("trigger", parameters.trigger);
  reader.read("binder", parameters.binder);
  reader.read("triangulation", parameters.triangulation);
  reader.read("lost_after", parameters.lost_after, {0.1, 1.0});
  reader.read("unseen_after", parameters.unseen_after, {0.01, 1.0});
  reader.read("call_timeout", parameters.call_timeout, {0.1, 60});
  reader.read("most_speed", parameters.limits.most_speed, {0.001, 1.5});
  reader.read("most_rate", parameters.limits.most_rate, {0.1, 10000});
  reader.read("most_length", parameters.limits.most_length, {0.01, 10});
  reader.read("approach_speed", parameters.timing.approach_speed, {0.001, 1.5});
  reader.read("stall", parameters.timing.stall, {0.5, 60});
  reader.read("patience", parameters.timing.patience, {0.1, 60});
  parameters.session.stall = parameters.timing.stall;
  load_session(reader, parameters.session);
  load_limits(reader, parameters.calibration_limits);
  reader.refuse_unknown();
  return parameters;
}

}  // namespace scan_cell
