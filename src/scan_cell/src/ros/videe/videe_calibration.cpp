// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "videe/videe_calibration.h"

#include <fmt/format.h>

#include <cstdio>
#include <ctime>

#include "scan_calibration/taught_poses.h"
#include "sequence/session_request.h"
#include "videe/videe_wait.h"

namespace scan_cell {

using scan_cell_common::Refused;
using scan_cell_msgs::CalibrateResult;

namespace {

/// 20261122_031500, UTC
std::string time_stamp() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof(text), "%Y%m%d_%H%M%S", &parts);
  return text;
}

/// @param lasers mask of the calibrated lasers
std::string figures(const CalibrateResult& result, std::uint8_t lasers) {
  const scan_cell_msgs::CalibrationFigures& held_out = result.held_out;
  char text[64];
  std::snprintf(text, sizeof(text), " reprojection_rms_px=%.4f", held_out.reprojection_rms_px);
  std::string line = text;
  const std::vector<int> calibrated = lasers_in(lasers);
  for (std::size_t i = 0; i < held_out.laser_plane_rms_mm.size(); ++i) {
    std::snprintf(text, sizeof(text), " laser_plane_rms_mm_%d=%.4f", calibrated.at(i),
                  held_out.laser_plane_rms_mm[i]);
    line += text;
  }
  std::snprintf(text, sizeof(text), " board_scatter_mm=%.4f", held_out.board_scatter_mm);
  return line + text + " model=" + result.model + " report=" + result.report;
}

}  // namespace

VideeCalibration::VideeCalibration(ros::NodeHandle node,
                                   const VideeCalibrationParameters& parameters,
                                   const std::string& action, const CellWatcher& watcher,
                                   double call_timeout)
    : parameters_(parameters),
      action_(action),
      watcher_(watcher),
      call_timeout_(call_timeout),
      client_(node, action) {}

std::string VideeCalibration::init() {
  if (parameters_.poses.empty()) {
    throw Refused("INIT_CALIBRATION", "no file of taught poses",
                  "set calibration/poses of videe_node");
  }
  const auto taught = scan_calibration::load_taught_poses(parameters_.poses);
  ready_ = true;
  return fmt::format("poses={}", taught.poses.size());
}

scan_cell_msgs::CalibrateGoal VideeCalibration::goal() const {
  scan_cell_msgs::CalibrateGoal goal;
  goal.poses = parameters_.poses;
  goal.session = parameters_.sessions + "/session_" + time_stamp();
  goal.output = parameters_.output;
  goal.board_columns = static_cast<std::uint32_t>(parameters_.board_columns);
  goal.board_rows = static_cast<std::uint32_t>(parameters_.board_rows);
  goal.square_size = parameters_.square_size;
  goal.lasers = static_cast<std::uint8_t>(parameters_.lasers);
  goal.scanner = parameters_.scanner;
  goal.lasers_alone = static_cast<unsigned char>(parameters_.lasers_alone);
  goal.board_exposure = parameters_.board_exposure;
  goal.line_exposure = parameters_.line_exposure;
  return goal;
}

std::string VideeCalibration::perform(const VideeServer::ClientThere& client_there) {
  if (!ready_) {
    throw Refused("PERFORM_CALIBRATION", "not prepared", "send INIT_CALIBRATION first");
  }
  wait_for_server(client_, action_, call_timeout_);
  scan_cell_msgs::CalibrateGoal wanted = goal();
  wanted.watcher = watcher_.name(call_timeout_);
  send_goal(client_, action_, wanted, call_timeout_);
  running_ = true;
  const auto result = wait_for_result(client_, action_, client_there, running_);
  if (result->outcome != CalibrateResult::FINISHED) {
    throw Refused("calibration '" + wanted.session + "'", "ended early", result->message);
  }
  const std::string counts = fmt::format("session={} views={} skipped={}", wanted.session,
                                         result->views, result->skipped.size());
  return result->model.empty() ? counts : counts + figures(*result, wanted.lasers);
}

void VideeCalibration::reset() {
  ready_ = false;
  if (!running_) return;
  running_ = false;
  cancel_and_wait(client_, action_);
}

}  // namespace scan_cell
