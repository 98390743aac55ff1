// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "sequence/session_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {
namespace {

constexpr double kMoving = 0.5;  // share of the time of a pose; a guess for the progress bar

/// [Hz] of the pulses with an exposure [s]
double rate_for(double exposure, double most) {
  constexpr double kDuty = 0.5;  // share of a period that may be exposure; chosen
  return std::min(most, kDuty / exposure);
}

}  // namespace

SessionSequence::SessionSequence(Robot& robot, SnapshotCamera& camera, Trigger& trigger,
                                 SessionObserver& observer, const SessionLimits& limits,
                                 const Timing& timing)
    : robot_(robot),
      camera_(camera),
      trigger_(trigger),
      observer_(observer),
      limits_(limits),
      timing_(timing),
      supervisor_(robot, trigger, {}, timing) {}

SessionEnd SessionSequence::run(const SessionRequest& request, const WhyToCancel& why_to_cancel) {
  supervisor_.begin(why_to_cancel);
  prepared_ = false;
  SessionEnd result;
  try {
    record(request, result);
  } catch (const EndEarly& early) {
    result.end = {early.outcome, early.message};
  } catch (const std::exception& error) {  // of any kind: the cell must be made safe
    result.end = {Outcome::kStageFailed, error.what()};
  }
  finish(result.end);
  return result;
}

void SessionSequence::record(const SessionRequest& request, SessionEnd& result) {
  on(Outcome::kRefused, [&] { check(request, limits_); });
  pose_ = 0;
  poses_ = request.poses.size();
  tell("read the positions", 0);
  supervisor_.wait_until_well();
  check_armings(request);
  prepared_ = true;
  on(Outcome::kCameraLost, [&] { camera_.prepare(); });
  on_robot([&] { robot_.set_linear_motion(timing_.speed); });
  int blind = 0;
  for (pose_ = 0; pose_ < poses_; ++pose_) {
    try {
      visit(request.poses[pose_], request);
      ++result.views;
      blind = 0;
    } catch (const SkipPose& skip) {
      result.skipped.push_back({request.poses[pose_].name, skip.reason});
      blind = skip.blind ? blind + 1 : 0;
      if (blind >= timing_.max_blind_poses) throw EndEarly{Outcome::kCameraLost, skip.reason};
    }
  }
}

/// A trigger that cannot check shows at the first pose.
void SessionSequence::check_armings(const SessionRequest& request) {
  const auto check_arming = [this](double exposure, std::uint8_t lasers) {
    on(Outcome::kRefused, Outcome::kTriggerLost, [&] {
      trigger_.check(rate_for(exposure, timing_.rate), {lasers, false});
    });
  };
  check_arming(request.board_exposure, 0);
  for (const int laser : lasers_in(request.lasers))
    check_arming(request.line_exposure, static_cast<std::uint8_t>(1 << laser));
}

void SessionSequence::visit(const TaughtPose& pose, const SessionRequest& request) {
  const std::vector<int> lasers = lasers_in(request.lasers);
  const double images = static_cast<double>(lasers.size()) + 1;
  const auto tell_image = [&](const std::string& what, double taken) {
    tell("take an image of " + what, kMoving + (1 - kMoving) * taken / images);
  };
  move_to(pose.flange);
  tell("wait until still", kMoving);
  TakenView view;
  view.base_to_flange = rest();
  tell_image("the board", 0);
  view.board = grab(request.board_exposure, 0, "the board");
  for (const int laser : lasers) {
    const std::string name = fmt::format("laser_{}", laser);
    tell_image(name, static_cast<double>(view.lines.size()) + 1);
    view.lines.push_back(grab(request.line_exposure, static_cast<std::uint8_t>(1 << laser), name));
  }
  if (!is_same(rest(), view.base_to_flange)) {
    throw SkipPose{"the robot moved while images were taken"};
  }
  on(Outcome::kStageFailed, [&] { observer_.on_view(view); });
}

void SessionSequence::move_to(const Eigen::Isometry3d& flange) {
  tell("move", 0);
  try {
    supervisor_.start_move({flange, std::nullopt}, 0);
    supervisor_.wait_for_motion([&](double progress) { tell("move", kMoving * progress); });
  } catch (const EndEarly& failure) {
    skip_or_end(failure);
  }
}

/// Skips only a target that the robot refused. If the robot was stopped, made no progress or could
/// not move, it would otherwise move by itself once it can again.
void SessionSequence::skip_or_end(const EndEarly& failure) {
  if (failure.outcome != Outcome::kMotionFailed ||
      robot_.motion().state != Motion::State::kFailed) {
    throw failure;
  }
  supervisor_.stop_robot();
  std::string hindrance;
  supervisor_.wait_for(timing_.aftermath, [&] {
    hindrance = robot_.hindrance();
    return !hindrance.empty();
  });
  if (!hindrance.empty()) {
    throw EndEarly{Outcome::kMotionFailed, failure.message + " (" + hindrance + ")"};
  }
  throw SkipPose{failure.message};
}

Eigen::Isometry3d SessionSequence::rest() {
  supervisor_.wait_for(timing_.settle, [] { return false; });
  const double deadline = monotonic_now() + timing_.still_patience;
  const auto measure = [this] { return on_robot([this] { return robot_.static_pose(); }); };
  Eigen::Isometry3d before = measure();
  while (true) {
    supervisor_.wait_for(timing_.still_interval, [] { return false; });
    const Eigen::Isometry3d now = measure();
    if (is_same(before, now)) return now;
    if (monotonic_now() > deadline) throw SkipPose{"the robot does not come to rest"};
    before = now;
  }
}

bool SessionSequence::is_same(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other) const {
  const Eigen::Isometry3d step = one.inverse() * other;
  return step.translation().norm() <= timing_.still_position &&
         Eigen::AngleAxisd(step.linear()).angle() <= timing_.still_angle;
}

Snapshot SessionSequence::grab(double exposure, std::uint8_t lasers, const std::string& what) {
  std::optional<Snapshot> taken;
  std::string trouble = "no image came";
  try {
    camera_.start(exposure);
    supervisor_.arm(rate_for(exposure, timing_.rate), {lasers, false});
    supervisor_.wait_for(timing_.image_patience, [&] {
      taken = camera_.snapshot();
      return taken.has_value();
    });
  } catch (const scan_cell_common::Error& error) {
    trouble = error.what();
  }
  disarm();
  camera_.stop();
  if (!taken) throw SkipPose{"camera: no image of " + what + ": " + trouble, true};
  return *taken;
}

void SessionSequence::disarm() {
  const Disarmed disarmed = supervisor_.disarm();
  if (!disarmed.trouble.empty()) throw EndEarly{Outcome::kTriggerLost, disarmed.trouble};
}

void SessionSequence::finish(SequenceEnd& end) {
  const Disarmed disarmed = supervisor_.disarm();
  if (!disarmed.trouble.empty()) worsen(end, Outcome::kTriggerLost, disarmed.trouble);
  supervisor_.stop_robot();
  if (!prepared_) return;
  camera_.stop();
  const std::string trouble = camera_.restore();
  if (!trouble.empty()) worsen(end, Outcome::kCameraLost, trouble);
}

void SessionSequence::tell(const std::string& doing, double share) {
  const double done = static_cast<double>(pose_) + share;
  observer_.on_progress(static_cast<int>(pose_) + 1, doing, done / static_cast<double>(poses_));
}

}  // namespace scan_cell
