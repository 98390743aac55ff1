// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters/parameters.h"

#include <algorithm>

#include "scan_cell_common/parameters/parameter_table.h"

namespace scan_cell {

using scan_cell_common::Also;
using scan_cell_common::ParameterTable;

double Parameters::silence_allowed(double rate) const {
  constexpr double kPeriods = 5;    // of frames; chosen
  constexpr double kLongest = 1.0;  // [s] lasers must be off two seconds after a device is lost
  return std::max(lost_after, std::min(kLongest, kPeriods / rate));
}

namespace {

void describe_names(ParameterTable& table, Parameters& p) {
  table.add(
      "base_frame", p.base_frame,
      "frame in which the robot's driver expects targets; goals in other frames are transformed by "
      "tf");
  table.add("flange_frame", p.flange_frame, "frame that the robot's driver publishes on `/tf`");
  table.add(
      "robot", p.robot,
      "node with the action `~move`, the topic `~status`, the speed services and, for the check "
      "of a program, `~check_motions`");
  table.add("camera", p.camera, "node with `~set_acquisition` and `~profiles`");
  table.add(
      "trigger", p.trigger,
      "node with `~arm`, `~disarm`, `~keep_alive`, `~events`, `~state` and, for the check of a "
      "program, `~check_arm`");
  table.add("binder", p.binder, "node with `~start`, `~check_run`, `~start_run` and `~finish`");
  table.add("triangulation", p.triangulation,
            "node with `~start`, `~check_run`, `~finish` and `~cloud`");
}

void describe_scan(ParameterTable& table, Parameters& p) {
  table.add("lost_after", p.lost_after, {0.1, 1.0, "s"},
            "a device counts as lost after this long without a message (five frame periods if that "
            "is longer, up to 1 s)");
  table.add("unseen_after", p.unseen_after, {0.01, 1.0, "s"},
            "in a motion with a laser on, the lasers go off after this long without a pose of the "
            "flange (on `/tf`); 0.5 with `sim:=true`");
  table.add("call_timeout", p.call_timeout, {0.1, 60, "s"},
            "longest wait for a service (0.75 s for the trigger's, 0.5 s to stop the camera)");
  table.add("max_speed", p.limits.max_speed, {0.001, 1.5, "m/s"}, "fastest scan allowed");
  table.renamed("most_speed", "max_speed");
  table.add("max_rate", p.limits.max_rate, {0.1, 10000, "Hz"},
            "highest frame rate allowed; the lowest is 2 Hz");
  table.renamed("most_rate", "max_rate");
  table.add("max_length", p.limits.max_length, {0.01, 10, "m"}, "longest pass allowed");
  table.renamed("most_length", "max_length");
  table.add("approach_speed", p.timing.approach_speed, {0.001, 1.5, "m/s"}, "speed to the start");
  table.add("stall", p.timing.stall, {0.5, 60, "s"},
            "a motion has failed after this long without progress");
  table.add("patience", p.timing.patience, {0.1, 60, "s"},
            "wait for late frames and poses at the end of a scan; starts again with each one that "
            "arrives");
}

void describe_calibration(ParameterTable& table, SessionSequence::Timing& session,
                          scan_calibration::CalibrationLimits& limits) {
  table.add("calibration/speed", session.speed, {0.001, 1.5, "m/s"},
            "speed from taught pose to taught pose");
  table.add("calibration/settle", session.settle, {0, 60, "s"},
            "wait after a motion, before the pose is read");
  table.add("calibration/still_position", session.still_position, {1e-6, 0.01, "m"},
            "two measured poses that differ by no more than this count as the same");
  table.add("calibration/still_angle", session.still_angle, {1e-6, 0.1, "rad"}, "the same");
  table.add("calibration/still_patience", session.still_patience, {0.1, 60, "s"},
            "longest wait for the robot to come to rest");
  table.add("calibration/rate", session.rate, {2, 100, "Hz"},
            "of the pulses while images are taken; less with exposures above 50 ms");
  table.add("calibration/image_patience", session.image_patience, {0.1, 60, "s"},
            "longest wait for one image");
  const auto limit = [&table](const std::string& name, double& value, const char* unit) {
    table.add("calibration/max_" + name, value, {1e-6, 1e6, unit, Also::kNone},
              "limit that a calibration must meet on held-out views for its model to be written");
    table.renamed("calibration/most_" + name, "calibration/max_" + name);
  };
  limit("reprojection_rms_px", limits.reprojection_rms_px, "px");
  limit("laser_plane_rms_mm", limits.laser_plane_rms_mm, "mm");
  limit("board_scatter_mm", limits.board_scatter_mm, "mm");
  limit("point_deviation_mm", limits.point_deviation_mm, "mm");
}

}  // namespace

void describe(ParameterTable& table, Parameters& parameters) {
  describe_names(table, parameters);
  describe_scan(table, parameters);
  describe_calibration(table, parameters.session, parameters.calibration_limits);
  table.group("work", parameters.work);
  parameters.session.stall = parameters.timing.stall;
}

}  // namespace scan_cell
