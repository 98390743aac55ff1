// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/motion/motion_control.h"

#include <algorithm>

namespace scan_cell_sim {
namespace {

constexpr double kHardBrake = 4;    // times a programmed stop; chosen
constexpr double kReduced = 0.25;   // [m/s] of the flange in mode programming: ISO 10218-1
constexpr double kNoTravel = 1e-9;  // [m] chosen

}  // namespace

const char* name_of(MotionStatus status) {
  switch (status) {
    case MotionStatus::kIdle:
      return "idle";
    case MotionStatus::kMoving:
      return "moving";
    case MotionStatus::kArrived:
      return "arrived";
    case MotionStatus::kStopped:
      return "stopped";
    case MotionStatus::kError:
      return "error";
  }
  return "error";
}

/// @throw ControllerRefusal unless the robot stands, ready for a motion
Joints MotionControl::standing(Nanoseconds now) const {
  readiness_.require_motion();
  const Run run = log_.at(now);
  if (!run.over(now)) {
    throw ControllerRefusal(ControllerErrorCode::kMoving, "the robot moves: STOP first");
  }
  return run.path->joints(run.way(now));
}

void MotionControl::move_to_pose(std::uint64_t motion, const Eigen::Isometry3d& flange,
                                 double camera_rate, Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Joints from = standing(now);
  const PlannedPath plan = settings_.in_joints ? plan_joint_path(from, reach(flange, from))
                                               : plan_line(from, flange, settings_.line);
  begin(motion, plan, camera_rate, now);
}

void MotionControl::move_along_arc(std::uint64_t motion, const Eigen::Isometry3d& via,
                                   const Eigen::Isometry3d& flange, double camera_rate,
                                   Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  begin(motion, plan_arc(standing(now), via, flange, settings_.line), camera_rate, now);
}

void MotionControl::move_to_joints(std::uint64_t motion, const Joints& joints, double camera_rate,
                                   Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  begin(motion, plan_joint_path(standing(now), joints), camera_rate, now);
}

void MotionControl::follow(std::uint64_t motion, const Eigen::Isometry3d& flange_to_tip,
                           const std::vector<TipWaypoint>& waypoints, std::size_t first,
                           Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  begin(motion, plan_tool_path(standing(now), flange_to_tip, waypoints, first, settings_.line), 0,
        now);
}

bool MotionControl::follows(Nanoseconds now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return !plan_.steps.empty() && ending_ == MotionStatus::kArrived && !log_.latest().over(now);
}

double MotionControl::cruise() const {
  const double programmed = std::min(plan_.speed * settings_.override, plan_.max_speed);
  return readiness_.mode() == ControllerMode::kProgramming ? std::min(programmed, reduced_)
                                                           : programmed;
}

/// Speeds from a way and a speed to the end of the plan.
SpeedProfile MotionControl::profile(double way, double speed) const {
  if (plan_.steps.empty())
    return SpeedProfile::trapezoid(way, 1, speed, cruise(), plan_.acceleration);
  const bool reduced = readiness_.mode() == ControllerMode::kProgramming;
  std::vector<LimitedWay> limited;
  for (const SpeedStep& step : plan_.steps) {
    const double programmed = std::min(step.speed * settings_.override, step.max_speed);
    limited.push_back(
        {step.end, reduced ? std::min(programmed, step.reduced_speed) : programmed, step.stop});
  }
  return SpeedProfile::through(limited, way, speed, plan_.acceleration);
}

void MotionControl::begin(std::uint64_t motion, const PlannedPath& plan, double camera_rate,
                          Nanoseconds now) {
  plan_ = plan;
  if (plan.steps.empty()) reduced_ = kReduced / std::max(flange_travel(*plan.path), kNoTravel);
  motion_ = motion;
  camera_rate_ = camera_rate;
  ending_ = MotionStatus::kArrived;
  why_.reset();
  ++begun_;
  log_.begin({now, plan.path, profile(0, 0), true});
}

void MotionControl::brake(double harder, MotionStatus ending, const std::optional<Complaint>& why,
                          Nanoseconds now) {
  const Run run = log_.latest();
  now = std::max(now, run.start);  // a run may have begun between reading the clock and locking
  if (run.over(now)) return;
  ending_ = ending;
  why_ = why;
  log_.begin({now, run.path,
              SpeedProfile::brake(run.way(now), run.speed(now), harder * plan_.acceleration),
              false});
}

void MotionControl::stop(const std::optional<Complaint>& why, Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (ending_ == MotionStatus::kArrived) brake(1, MotionStatus::kStopped, why, now);
}

void MotionControl::forget(Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (ending_ == MotionStatus::kArrived) brake(1, MotionStatus::kIdle, std::nullopt, now);
  ending_ = MotionStatus::kIdle;
  motion_ = 0;
  camera_rate_ = 0;
}

void MotionControl::cut_power(MotionStatus ending, const Complaint& why, Nanoseconds now,
                              const std::function<void()>& change) {
  const bool powered = readiness_.drives();
  change();
  if (powered && !readiness_.drives()) brake(kHardBrake, ending, why, now);
}

void MotionControl::fail(const std::string& text, Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Complaint alarm{ControllerErrorCode::kMotionFailed, text};
  cut_power(MotionStatus::kError, alarm, now, [&] { readiness_.raise(alarm); });
}

void MotionControl::power_off(Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Complaint off{ControllerErrorCode::kEmergencyStop, "the controller was switched off"};
  cut_power(MotionStatus::kStopped, off, now,
            [this] { readiness_.switch_drives(false, Readiness::Source::kPanel); });
}

void MotionControl::power_on(Nanoseconds now) {
  forget(now);
  const std::lock_guard<std::mutex> lock(mutex_);
  settings_ = {};
  readiness_.restart();
}

void MotionControl::press_e_stop(Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Complaint pressed{ControllerErrorCode::kEmergencyStop, "emergency stop"};
  cut_power(MotionStatus::kStopped, pressed, now, [this] { readiness_.press_e_stop(); });
}

void MotionControl::release_e_stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  readiness_.release_e_stop();
}

void MotionControl::select(ControllerMode mode, Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::string text = std::string("mode ") + name_of(mode) + " was selected";
  cut_power(MotionStatus::kStopped, {ControllerErrorCode::kMode, text}, now,
            [this, mode] { readiness_.select(mode); });
}

void MotionControl::switch_drives(bool on, Readiness::Source source, Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  cut_power(MotionStatus::kStopped, {ControllerErrorCode::kEmergencyStop, "the drives went off"},
            now, [&] { readiness_.switch_drives(on, source); });
}

void MotionControl::reset_alarms(Readiness::Source source) {
  const std::lock_guard<std::mutex> lock(mutex_);
  readiness_.reset_alarms(source);
}

MotionSettings MotionControl::settings() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return settings_;
}

void MotionControl::set(const MotionSettings& settings, Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  settings_ = settings;
  const Run run = log_.at(now);
  if (run.over(now) || ending_ != MotionStatus::kArrived) return;
  log_.begin({now, run.path, profile(run.way(now), run.speed(now)), true});
}

MotionState MotionControl::state(Nanoseconds now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Run run = log_.at(now);
  MotionState state;
  state.status = run.over(now) ? ending_ : MotionStatus::kMoving;
  state.motion = motion_;
  state.progress = motion_ == 0 ? 0 : run.way(now);
  state.camera_rate = camera_rate_;
  state.readiness = readiness_;
  if (state.status == MotionStatus::kStopped || state.status == MotionStatus::kError)
    state.why = why_;
  state.waypoint = motion_ == 0 ? 0 : run.path->waypoint(run.way(now));
  state.outputs = run.outputs(now);
  state.flange = run.path->flange(run.way(now));
  state.joints = run.path->joints(run.way(now));
  state.settings = settings_;
  return state;
}

std::uint64_t MotionControl::motions_begun() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return begun_;
}

}  // namespace scan_cell_sim
