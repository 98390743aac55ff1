// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "actions/calibrate_action.h"

#include <fmt/format.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <filesystem>

#include "actions/calibration_markers.h"
#include "scan_calibration/calibration.h"
#include "scan_calibration/calibration_files.h"
#include "scan_calibration/taught_poses.h"

namespace scan_cell {

using scan_cell_common::Refused;
using scan_cell_msgs::CalibrateGoal;
using scan_cell_msgs::CalibrateResult;

namespace {

constexpr double kRecording = 0.8;  // share of the whole time; a guess for the progress bar

std::vector<TaughtPose> load_poses(const std::string& path) {
  const scan_calibration::TaughtPoses taught = scan_calibration::load_taught_poses(path);
  if (!taught.has_orientation) {
    throw Refused(path, "points without orientation", "teach poses of the flange");
  }
  std::vector<TaughtPose> poses;
  for (std::size_t i = 0; i < taught.poses.size(); ++i)
    poses.push_back({fmt::format("line {}", taught.lines[i]), taught.poses[i]});
  return poses;
}

scan_calibration::Board board_of(const CalibrateGoal& goal) {
  constexpr std::uint32_t kLeast = 3;   // corners; chosen
  constexpr std::uint32_t kMost = 200;  // corners; chosen
  for (const std::uint32_t corners : {goal.board_columns, goal.board_rows}) {
    if (corners < kLeast || corners > kMost) {
      throw Refused("board",
                    fmt::format("{} x {} inner corners", goal.board_columns, goal.board_rows),
                    fmt::format("give {} to {} in each direction", kLeast, kMost));
    }
  }
  if (!(goal.square_size > 1e-4 && goal.square_size < 1)) {
    throw Refused("board", fmt::format("squares of {:g} m", goal.square_size),
                  "give their size in metres");
  }
  return {static_cast<int>(goal.board_columns), static_cast<int>(goal.board_rows),
          goal.square_size};
}

std::vector<std::string> names_of(std::uint8_t lasers) {
  std::vector<std::string> names;
  for (const int laser : lasers_in(lasers))
    names.push_back(fmt::format("laser_{}", laser));
  return names;
}

/// What to calibrate, and where the rest comes from.
scan_calibration::CalibrationOptions options_of(const CalibrateGoal& goal) {
  scan_calibration::CalibrationOptions options;
  options.lasers_alone = goal.lasers_alone != 0;
  if (!goal.scanner.empty())
    options.existing = scan_calibration::load_existing_scanner(goal.scanner);
  check(options, names_of(goal.lasers));
  return options;
}

scan_cell_msgs::CalibrationFigures to_message(const scan_calibration::Figures& figures) {
  scan_cell_msgs::CalibrationFigures message;
  message.reprojection_rms_px = figures.reprojection_rms_px;
  message.laser_plane_rms_mm = figures.laser_plane_rms_mm;
  message.board_scatter_mm = figures.board_scatter_mm;
  return message;
}

/// Why a run gave no model: the refusal, or every limit missed.
std::string why_not(const scan_calibration::CalibrationRun& found) {
  std::string text = found.reason;
  for (const scan_calibration::JudgedFigure& figure : found.judged) {
    if (figure.passed()) continue;
    text += fmt::format("{}{}: {:g}; the limit is {:g}", (text.empty() ? "" : "; "), figure.name,
                        figure.value, figure.limit);
  }
  return text;
}

}  // namespace

CalibrateAction::CalibrateAction(ros::NodeHandle node, const Parameters& parameters,
                                 CellDevices& devices, CellInUse& cell, const StateTopic& state)
    : parameters_(parameters),
      sequence_(devices.robot, devices.snapshots, devices.trigger, *this, parameters.session_limits,
                parameters.session),
      action_(node, "calibrate", cell, state, *this) {
  markers_publisher_ =
      node.advertise<visualization_msgs::MarkerArray>("calibration", 1, /*latch=*/true);
  action_.start();
}

CalibrateAction::~CalibrateAction() {
  action_.end();
}

std::string CalibrateAction::accept(const CalibrateGoal& goal) {
  SessionRequest request;
  request.poses = load_poses(goal.poses);
  request.lasers = goal.lasers;
  request.board_exposure = goal.board_exposure;
  request.line_exposure = goal.line_exposure;
  check(request, parameters_.session_limits);
  options_ = options_of(goal);  // before anything moves
  const scan_calibration::Board board = board_of(goal);
  recorder_ = std::make_unique<scan_calibration::SessionRecorder>(goal.session, board,
                                                                  names_of(goal.lasers));
  request_ = request;
  progress_ = 0;
  goal_ = goal;
  if (goal_.report.empty()) {
    goal_.report = (std::filesystem::path(goal.session) / "report.json").string();
  }
  return goal.session;
}

CalibrateResult CalibrateAction::run(const WhyToCancel& why_to_cancel) {
  const ros::WallTime start = ros::WallTime::now();
  CalibrateResult result;
  SequenceEnd end = record(why_to_cancel, result);
  result.outcome = static_cast<std::uint8_t>(end.outcome);
  result.message = end.message;
  if (end.outcome == Outcome::kFinished && !goal_.output.empty()) compute(why_to_cancel, result);
  result.seconds = (ros::WallTime::now() - start).toSec();
  if (result.outcome != CalibrateResult::FINISHED) {
    ROS_WARN("Calibration '%s' gave no model: %s", goal_.session.c_str(), result.message.c_str());
  }
  return result;
}

SequenceEnd CalibrateAction::record(const WhyToCancel& why_to_cancel, CalibrateResult& result) {
  const SessionEnd recorded = sequence_.run(request_, why_to_cancel);
  recorder_.reset();
  result.poses = static_cast<std::uint32_t>(request_.poses.size());
  result.views = static_cast<std::uint32_t>(recorded.views);
  for (const SkippedPose& pose : recorded.skipped) {
    result.skipped.push_back(pose.name + ": " + pose.reason);
    ROS_WARN("Taught pose skipped, %s", result.skipped.back().c_str());
  }
  return recorded.end;
}

void CalibrateAction::compute(const WhyToCancel& why_to_cancel, CalibrateResult& result) {
  constexpr double kReading = 0.6;  // share of the computing time; a guess for the progress bar
  const auto go_on = [&](const std::string& doing, double share) {
    const std::string why = why_to_cancel();
    if (!why.empty()) throw EndEarly{Outcome::kCancelled, why + ", while computing"};
    tell(0, doing, kRecording + (1 - kRecording) * share);
  };
  scan_calibration::ObservationOptions reading;
  reading.progress = [&](const std::string& what, int done, int total) {
    go_on("read the images: " + what, kReading * done / total);
  };
  scan_calibration::CalibrationOptions options = options_;
  options.progress = [&](const std::string& stage) { go_on(stage, kReading); };
  try {
    const auto found = scan_calibration::run_calibration(goal_.session, reading, options,
                                                         parameters_.calibration_limits);
    go_on("write the results", 1);
    save(found, result);
    if (found.calibration) {
      markers_publisher_.publish(calibration_markers(found, parameters_.base_frame));
    }
  } catch (const EndEarly& early) {
    result.outcome = static_cast<std::uint8_t>(early.outcome);
    result.message = early.message;
  } catch (const std::exception& error) {  // also of OpenCV: a session must not end the node
    result.outcome = CalibrateResult::NOT_CALIBRATED;
    result.message = error.what();
  }
}

void CalibrateAction::save(const scan_calibration::CalibrationRun& found,
                           CalibrateResult& result) const {
  const scan_calibration::WrittenFiles written = scan_calibration::save_calibration(
      found, {goal_.output, scan_calibration::camera_info_file(goal_.output), goal_.report});
  result.model = written.scanner;
  result.report = written.report;
  if (found.calibration) {
    result.fitted = to_message(found.calibration->fitted);
    result.held_out = to_message(found.calibration->held_out);
    result.kept = found.calibration->kept;
  }
  if (found.verdict != scan_calibration::CalibrationVerdict::kPassed) {
    result.outcome = CalibrateResult::NOT_CALIBRATED;
    result.message = why_not(found);
    return;
  }
  result.message =
      fmt::format("{} of {} views used", found.calibration->views.size(), result.views);
}

void CalibrateAction::on_progress(int pose, const std::string& doing, double progress) {
  tell(pose, doing, goal_.output.empty() ? progress : kRecording * progress);
}

void CalibrateAction::on_view(const TakenView& view) {
  std::vector<scan_calibration::RecordedLine> lines;
  for (const Snapshot& line : view.lines)
    lines.push_back({line.image, line.peaks});
  recorder_->add(view.base_to_flange, view.board.image, lines);
}

void CalibrateAction::tell(int pose, const std::string& doing, double progress) {
  constexpr double kPeriod = 0.1;             // [s] chosen
  progress_ = std::max(progress_, progress);  // repeated work does not set it back
  const ros::WallTime now = ros::WallTime::now();
  if (doing == last_doing_ && (now - last_feedback_).toSec() < kPeriod) return;
  last_feedback_ = now;
  last_doing_ = doing;
  scan_cell_msgs::CalibrateFeedback feedback;
  feedback.pose = static_cast<std::uint32_t>(pose);
  feedback.poses = static_cast<std::uint32_t>(request_.poses.size());
  feedback.doing = doing;
  feedback.progress = progress_;
  action_.publish(feedback);
}

}  // namespace scan_cell
