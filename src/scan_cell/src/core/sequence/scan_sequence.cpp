// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "sequence/scan_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "scan_cell_common/errors/errors.h"
#include "sequence/program_check.h"

namespace scan_cell {

ScanSequence::ScanSequence(Robot& robot, Camera& camera, Trigger& trigger, Stages& stages,
                           ScanObserver& observer, const ScanLimits& limits, const Timing& timing)
    : robot_(robot),
      camera_(camera),
      trigger_(trigger),
      stages_(stages),
      observer_(observer),
      limits_(limits),
      timing_(timing),
      supervisor_(robot, trigger,
                  {{&camera, Outcome::kCameraLost}, {&stages, Outcome::kStageFailed}}, timing) {}

SequenceEnd ScanSequence::run(const ScanRequest& request, const WhyToCancel& why_to_cancel) {
  supervisor_.begin(why_to_cancel);
  begin();
  SequenceEnd end;
  try {
    step(1, "read the positions");
    on(Outcome::kRefused, [&] { check(request, limits_); });
    runs_ = runs_of(request.passes);
    supervisor_.wait_until_well();
    warnings_ = check_runs({robot_, trigger_, stages_}, runs_, timing_.approach_speed);
    try_devices();
    for (run_ = 0; run_ < runs_.size(); ++run_) {
      approach(runs_[run_]);
      start_stages(request.scan_id);
      capture(runs_[run_]);
    }
    passes_finished_ = request.passes.size();
  } catch (const EndEarly& early) {
    end = {early.outcome, early.message};
  } catch (const std::exception& error) {  // of any kind: the cell must be made safe
    end = {Outcome::kStageFailed, error.what()};
  }
  return finish(end);
}

void ScanSequence::begin() {
  runs_.clear();
  run_ = passes_finished_ = 0;
  warnings_.clear();
  camera_settings_.reset();
  exposures_.clear();
  armings_.clear();
  armed_for_.clear();
  progress_ = {};
  capturing_ = stages_started_ = false;
}

/// Tries the settings of the passes on the camera itself, which knows best what is possible, and
/// asks whether the trigger would be armed, which depends on the exposure if lasers take turns.
void ScanSequence::try_devices() {
  std::string unchecked;
  for (const ScanRun& run : runs_) {
    const bool asks_camera = !run.camera.empty() || run.lighting.alternate;
    unchecked = check_arming(trigger_, run, asks_camera ? try_camera(run) : 0);
  }
  if (!unchecked.empty()) warnings_.push_back(unchecked);
}

/// Tries each setting once.
/// @return [s] exposure with this setting
double ScanSequence::try_camera(const ScanRun& run) {
  for (const auto& [settings, exposure] : exposures_) {
    if (settings == run.camera) return exposure;
  }
  on(Outcome::kRefused, Outcome::kCameraLost, [&] {
    try {
      start_camera(run.camera);
    } catch (const scan_cell_common::Refused& refused) {
      throw scan_cell_common::Refused(run.name + ": camera", "settings refused", refused.what());
    }
  });
  exposures_.emplace_back(run.camera, camera_.exposure());
  return camera_.exposure();
}

void ScanSequence::start_camera(const PassCamera& settings) {
  if (camera_settings_ == settings) return;
  camera_settings_ = PassCamera();  // whatever happens, they must be restored
  camera_.start(settings);
  camera_settings_ = settings;
}

void ScanSequence::approach(const ScanRun& run) {
  passes_finished_ = run.pass;
  step(2, "move to the start");
  if (run.approach) {
    on_robot([&] { robot_.set_linear_motion(timing_.approach_speed); });
    supervisor_.start_move({run.start, std::nullopt}, 0);
    wait_for_motion();
  }
  step(3, "set speed and linear motion");
  on_robot([&] { robot_.set_linear_motion(run.speed); });
}

void ScanSequence::start_stages(const std::string& scan_id) {
  step(4, "prepare binder and triangulation");
  if (!stages_started_) on(Outcome::kStageFailed, [&] { stages_.start(scan_id); });
  stages_started_ = true;
  on(Outcome::kStageFailed, [&] { stages_.start_run(runs_[run_]); });
  step(5, "start the camera");
  if (!capturing_) observer_.on_capture_begins();
  capturing_ = true;
  on(Outcome::kCameraLost, [&] { start_camera(runs_[run_].camera); });
}

void ScanSequence::capture(const ScanRun& run) {
  step(6, "scan");
  supervisor_.start_move(run.moves.front(), run.rate);
  supervisor_.wait_until_moving();
  Lighting lighting = run.lighting;
  lighting.exposure = camera_.exposure();
  supervisor_.arm(run.rate, lighting);
  camera_.expect_profiles(run.rate);
  const double part = 1 / static_cast<double>(run.moves.size());
  wait_for_motion(0, part);
  for (std::size_t i = 1; i < run.moves.size(); ++i) {
    supervisor_.start_move(run.moves[i], run.rate);
    wait_for_motion(static_cast<double>(i) * part, part);
  }
  camera_.expect_profiles(0);
  const std::string trouble = disarm();
  if (!trouble.empty()) throw EndEarly{Outcome::kTriggerLost, trouble};
}

SequenceEnd ScanSequence::finish(SequenceEnd end) {
  const std::string trouble = disarm();
  if (!trouble.empty()) worsen(end, Outcome::kTriggerLost, trouble);
  supervisor_.stop_robot();
  if (capturing_) step(7, "stop");
  if (stages_started_) finish_stages(end);
  if (camera_settings_) {
    camera_.stop();
    const std::string left = camera_.restore();
    if (!left.empty()) warnings_.push_back(left);
  }
  if (capturing_) observer_.on_capture_ends();
  capturing_ = false;
  return end;
}

std::string ScanSequence::disarm() {
  const Disarmed disarmed = supervisor_.disarm();
  if (disarmed.pulses > 0) {
    armings_.push_back({disarmed.arming, disarmed.pulses});
    armed_for_.push_back(runs_.at(run_).name);
  }
  return disarmed.trouble;
}

void ScanSequence::finish_stages(SequenceEnd& end) {
  const bool whole = end.outcome == Outcome::kFinished;
  const double patience = whole ? timing_.patience : timing_.patience_after_failure;
  if (whole) step(8, "bind and triangulate");
  try {
    const std::string lost = find_lost_frames(stages_.bind(armings_, patience));
    if (whole && !lost.empty()) worsen(end, Outcome::kCameraLost, lost);
  } catch (const std::exception& error) {  // of any kind: the camera must be restored
    worsen(end, Outcome::kStageFailed, error.what());
  }
  try {
    stages_.triangulate(end.outcome == Outcome::kFinished, patience);
    const std::string apart = stages_.disagreement();
    if (!apart.empty()) worsen(end, Outcome::kPassesDisagree, apart);
  } catch (const std::exception& error) {  // of any kind: the camera must be restored
    worsen(end, Outcome::kStageFailed, error.what());
  }
}

std::string ScanSequence::find_lost_frames(const std::vector<std::uint64_t>& missing) const {
  constexpr std::uint64_t kMissing = 5;  // in a row at the end: more than a lost packet; chosen
  for (std::size_t i = 0; i < missing.size(); ++i) {
    if (missing[i] == 0 || missing[i] < std::min(kMissing, armings_[i].pulses)) continue;
    return fmt::format(
        "camera: no frame of the last {} of {} pulses{}; check the camera's cable and trigger "
        "input",
        missing[i], armings_[i].pulses, runs_.size() > 1 ? " of " + armed_for_[i] : "");
  }
  return "";
}

void ScanSequence::step(int number, const std::string& name) {
  progress_.pass = runs_.empty() ? 0 : runs_[std::min(run_, runs_.size() - 1)].pass;
  progress_.step = number;
  progress_.name = name;
  show(0);
}

/// @param share of the step, 0 .. 1
void ScanSequence::show(double share) {
  constexpr double kSteps = 8;
  constexpr int kOfRuns = 6;  // the first steps, which belong to runs
  const double steps = progress_.step - 1 + share;
  if (progress_.step <= kOfRuns && !runs_.empty()) {
    const auto run = static_cast<double>(run_);
    progress_.whole = (run * kOfRuns + steps) / (kSteps * static_cast<double>(runs_.size()));
  } else {
    progress_.whole = steps / kSteps;
  }
  observer_.on_progress(progress_);
}

/// @param begun, part the motion is `part` of the step, after `begun` of it
void ScanSequence::wait_for_motion(double begun, double part) {
  supervisor_.wait_for_motion([=](double progress) { show(begun + part * progress); });
}

}  // namespace scan_cell
