// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/scan_sequence.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "scan_cell_common/errors.h"

namespace scan_cell {
namespace {

constexpr double kSteps = 8;

/// Ends a scan early, from any depth of the sequence.
struct EndScan {
  ScanOutcome outcome;
  std::string message;
};

/// Carries out what belongs to one device; an error of it ends the scan with that device's outcome.
template <class Call>
void on(ScanOutcome outcome, const Call& call) {
  try {
    call();
  } catch (const scan_cell_common::Error& error) {
    throw EndScan{outcome, error.what()};
  }
}

/// Adds what went wrong besides, or after all was well.
void worsen(ScanEnd& end, ScanOutcome outcome, const std::string& why) {
  if (end.outcome == ScanOutcome::Finished) {
    end = {outcome, why};
  } else {
    end.message += "; besides: " + why;
  }
}

double now() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(time).count();
}

}  // namespace

ScanSequence::ScanSequence(Robot& robot, Camera& camera, Trigger& trigger, Stages& stages,
                           ScanObserver& observer, const ScanLimits& limits, const Timing& timing)
    : robot_(robot),
      camera_(camera),
      trigger_(trigger),
      stages_(stages),
      observer_(observer),
      limits_(limits),
      timing_(timing) {}

ScanEnd ScanSequence::run(const ScanRequest& request, const std::atomic<bool>& cancel) {
  cancel_ = &cancel;
  step_ = 0;
  moving_ = capturing_ = armed_ = stages_started_ = false;
  ScanEnd end;
  try {
    prepare(request);
    capture(request);
  } catch (const EndScan& early) {
    end = {early.outcome, early.message};
  }
  return finish(end);
}

void ScanSequence::prepare(const ScanRequest& request) {
  step(1, "read the positions");
  on(ScanOutcome::Refused, [&] { check(request, limits_); });
  wait_until_well();
  step(2, "move to the start");
  on(ScanOutcome::RobotLost, [&] { robot_.set_linear_motion(timing_.approach_speed); });
  start_move(request.start, 0);
  wait_for_motion();
  step(3, "set speed and linear motion");
  on(ScanOutcome::RobotLost, [&] { robot_.set_linear_motion(request.speed); });
  step(4, "prepare binder and triangulation");
  on(ScanOutcome::StageFailed, [&] { stages_.start(request.scan_id); });
  stages_started_ = true;
}

void ScanSequence::capture(const ScanRequest& request) {
  step(5, "start the camera");
  observer_.on_capture_begins();
  capturing_ = true;
  on(ScanOutcome::CameraLost, [&] { camera_.start(); });
  step(6, "scan");
  start_move(request.end, request.rate);
  wait_until_moving();
  armed_ = true;
  on(ScanOutcome::TriggerLost, [&] { trigger_.arm(request.rate, request.lasers); });
  camera_.expect_profiles(request.rate);
  wait_for_motion();
}

ScanEnd ScanSequence::finish(ScanEnd end) {
  const std::uint64_t pulses = disarm(end);
  if (moving_) robot_.stop();
  moving_ = false;
  if (capturing_) step(7, "stop");
  if (stages_started_) finish_stages(pulses, end);
  if (capturing_) {
    camera_.stop();
    observer_.on_capture_ends();
  }
  capturing_ = false;
  return end;
}

std::uint64_t ScanSequence::disarm(ScanEnd& end) {
  if (!armed_) return 0;
  armed_ = false;
  const Disarmed disarmed = trigger_.disarm();
  if (!disarmed.trouble.empty()) worsen(end, ScanOutcome::TriggerLost, disarmed.trouble);
  return disarmed.pulses;
}

void ScanSequence::finish_stages(std::uint64_t pulses, ScanEnd& end) {
  constexpr std::uint64_t kMissing = 5;  // in a row at the end: more than a packet that got lost
  const bool whole = end.outcome == ScanOutcome::Finished;
  const double patience = whole ? timing_.patience : timing_.patience_after_failure;
  if (whole) step(8, "bind and triangulate");
  try {
    const std::uint64_t missing = stages_.bind(pulses, patience);
    if (whole && missing > 0 && missing >= std::min(kMissing, pulses)) {
      worsen(end, ScanOutcome::CameraLost,
             "camera: no frame of the last " + std::to_string(missing) + " of " +
                 std::to_string(pulses) + " pulses; check the camera's cable and trigger input");
    }
  } catch (const scan_cell_common::Error& error) {
    worsen(end, ScanOutcome::StageFailed, error.what());
  }
  try {
    stages_.triangulate(end.outcome == ScanOutcome::Finished, patience);
  } catch (const scan_cell_common::Error& error) {
    worsen(end, ScanOutcome::StageFailed, error.what());
  }
}

void ScanSequence::step(int number, const std::string& name) {
  step_ = number;
  step_name_ = name;
  observer_.on_progress(number, name, (number - 1) / kSteps);
}

void ScanSequence::start_move(const Eigen::Isometry3d& target, double camera_rate) {
  moving_ = true;
  on(ScanOutcome::RobotLost, [&] { robot_.start_move(target, camera_rate); });
}

void ScanSequence::wait_until_well() {
  const double deadline = now() + timing_.readiness;
  while (!robot_.trouble().empty() && now() < deadline && !*cancel_) {
    std::this_thread::sleep_for(std::chrono::duration<double>(timing_.poll));
  }
  watch();
}

void ScanSequence::wait_until_moving() {
  const double deadline = now() + timing_.stall;
  Motion motion = robot_.motion();
  while (motion.state == Motion::State::Moving && motion.progress <= 0) {
    end_if_stalled(deadline);
    sleep_and_watch();
    motion = robot_.motion();
  }
  end_if_failed(motion);
}

void ScanSequence::wait_for_motion() {
  double deadline = now() + timing_.stall;
  double progress = 0;
  Motion motion = robot_.motion();
  while (motion.state == Motion::State::Moving) {
    end_if_stalled(deadline);
    sleep_and_watch();
    motion = robot_.motion();
    if (motion.progress > progress) deadline = now() + timing_.stall;
    progress = motion.progress;
    observer_.on_progress(step_, step_name_, (step_ - 1 + progress) / kSteps);
  }
  end_if_failed(motion);
  moving_ = false;
}

void ScanSequence::end_if_failed(const Motion& motion) {
  if (motion.state == Motion::State::Failed) {
    throw EndScan{ScanOutcome::MotionFailed, motion.message};
  }
  if (motion.state == Motion::State::Lost) throw EndScan{ScanOutcome::RobotLost, motion.message};
}

void ScanSequence::end_if_stalled(double deadline) const {
  if (now() < deadline) return;
  throw EndScan{ScanOutcome::MotionFailed, "the robot made no way for " +
                                               std::to_string(timing_.stall) +
                                               " s; check drives, override and obstacles"};
}

void ScanSequence::sleep_and_watch() {
  std::this_thread::sleep_for(std::chrono::duration<double>(timing_.poll));
  watch();
}

void ScanSequence::watch() {
  const auto end_on_trouble = [](const Device& device, ScanOutcome outcome) {
    const std::string trouble = device.trouble();
    if (!trouble.empty()) throw EndScan{outcome, trouble};
  };
  if (*cancel_) throw EndScan{ScanOutcome::Cancelled, "cancelled by the client"};
  end_on_trouble(robot_, ScanOutcome::RobotLost);
  end_on_trouble(camera_, ScanOutcome::CameraLost);
  end_on_trouble(trigger_, ScanOutcome::TriggerLost);
  end_on_trouble(stages_, ScanOutcome::StageFailed);
  if (armed_ && now() - last_keep_alive_ >= timing_.keep_alive) {
    trigger_.keep_alive();
    last_keep_alive_ = now();
  }
}

}  // namespace scan_cell
