// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "sequence/scan_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {
namespace {

constexpr double kSteps = 8;

}  // namespace

ScanSequence::ScanSequence(Robot& robot, Camera& camera, Trigger& trigger, Stages& stages,
                           ScanObserver& observer, const ScanLimits& limits, const Timing& timing)
    : robot_(robot),
      camera_(camera),
      stages_(stages),
      observer_(observer),
      limits_(limits),
      timing_(timing),
      supervisor_(robot, trigger,
                  {{&camera, Outcome::kCameraLost}, {&stages, Outcome::kStageFailed}}, timing) {}

SequenceEnd ScanSequence::run(const ScanRequest& request, const WhyToCancel& why_to_cancel) {
  supervisor_.begin(why_to_cancel);
  step_ = 0;
  capturing_ = stages_started_ = false;
  SequenceEnd end;
  try {
    prepare(request);
    capture(request);
  } catch (const EndEarly& early) {
    end = {early.outcome, early.message};
  } catch (const std::exception& error) {  // whatever it is: the cell must be made safe
    end = {Outcome::kStageFailed, error.what()};
  }
  return finish(end);
}

void ScanSequence::prepare(const ScanRequest& request) {
  step(1, "read the positions");
  on(Outcome::kRefused, [&] { check(request, limits_); });
  supervisor_.wait_until_well();
  step(2, "move to the start");
  on_robot([&] { robot_.set_linear_motion(timing_.approach_speed); });
  supervisor_.start_move(request.start, 0);
  wait_for_motion();
  step(3, "set speed and linear motion");
  on_robot([&] { robot_.set_linear_motion(request.speed); });
  step(4, "prepare binder and triangulation");
  on(Outcome::kStageFailed, [&] { stages_.start(request.scan_id); });
  stages_started_ = true;
}

void ScanSequence::capture(const ScanRequest& request) {
  step(5, "start the camera");
  observer_.on_capture_begins();
  capturing_ = true;
  on(Outcome::kCameraLost, [&] { camera_.start(); });
  step(6, "scan");
  supervisor_.start_move(request.end, request.rate);
  supervisor_.wait_until_moving();
  supervisor_.arm(request.rate, {request.lasers, false});
  camera_.expect_profiles(request.rate);
  wait_for_motion();
}

SequenceEnd ScanSequence::finish(SequenceEnd end) {
  const std::uint64_t pulses = disarm(end);
  supervisor_.stop_robot();
  if (capturing_) step(7, "stop");
  if (stages_started_) finish_stages(pulses, end);
  if (capturing_) {
    camera_.stop();
    observer_.on_capture_ends();
  }
  capturing_ = false;
  return end;
}

std::uint64_t ScanSequence::disarm(SequenceEnd& end) {
  const Disarmed disarmed = supervisor_.disarm();
  if (!disarmed.trouble.empty()) worsen(end, Outcome::kTriggerLost, disarmed.trouble);
  return disarmed.pulses;
}

void ScanSequence::finish_stages(std::uint64_t pulses, SequenceEnd& end) {
  constexpr std::uint64_t kMissing = 5;  // in a row at the end: more than a lost packet; chosen
  const bool whole = end.outcome == Outcome::kFinished;
  const double patience = whole ? timing_.patience : timing_.patience_after_failure;
  if (whole) step(8, "bind and triangulate");
  try {
    const std::uint64_t missing = stages_.bind(pulses, patience);
    if (whole && missing > 0 && missing >= std::min(kMissing, pulses)) {
      worsen(end, Outcome::kCameraLost,
             fmt::format("camera: no frame of the last {} of {} pulses; check the camera's cable "
                         "and trigger input",
                         missing, pulses));
    }
  } catch (const scan_cell_common::Error& error) {
    worsen(end, Outcome::kStageFailed, error.what());
  }
  try {
    stages_.triangulate(end.outcome == Outcome::kFinished, patience);
  } catch (const scan_cell_common::Error& error) {
    worsen(end, Outcome::kStageFailed, error.what());
  }
}

void ScanSequence::step(int number, const std::string& name) {
  step_ = number;
  step_name_ = name;
  observer_.on_progress(number, name, (number - 1) / kSteps);
}

void ScanSequence::wait_for_motion() {
  supervisor_.wait_for_motion([this](double progress) {
    observer_.on_progress(step_, step_name_, (step_ - 1 + progress) / kSteps);
  });
}

}  // namespace scan_cell
