// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "sequence/supervisor.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace scan_cell {

double monotonic_now() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(time).count();
}

Supervisor::Supervisor(Robot& robot, Trigger& trigger, std::vector<Watched> others,
                       const Timing& timing)
    : robot_(robot), trigger_(trigger), watched_(std::move(others)), timing_(timing) {
  watched_.insert(watched_.begin(), Watched{&robot_, Outcome::kRobotLost});
  watched_.push_back({&trigger_, Outcome::kTriggerLost});
}

void Supervisor::begin(WhyToCancel why_to_cancel) {
  why_to_cancel_ = std::move(why_to_cancel);
  moving_ = armed_ = unseen_before_ = false;
  last_keep_alive_ = 0;
}

void Supervisor::wait_until_well() {
  const double deadline = monotonic_now() + timing_.readiness;
  while (!robot_.trouble().empty() && monotonic_now() < deadline && why_to_cancel_().empty()) {
    std::this_thread::sleep_for(std::chrono::duration<double>(timing_.poll));
  }
  watch();
}

void Supervisor::start_move(const MoveTarget& target, double camera_rate) {
  start_other([&] { robot_.start_move(target, camera_rate); });
}

void Supervisor::start_other(const std::function<void()>& start) {
  watch();  // no motion begins after a cancel
  moving_ = true;
  on_robot(start);
}

void Supervisor::wait_until_moving() {
  const double deadline = monotonic_now() + timing_.stall;
  Motion motion = robot_.motion();
  while (motion.state == Motion::State::kMoving && motion.progress <= 0) {
    end_if_stalled(deadline);
    sleep_and_watch();
    motion = robot_.motion();
  }
  end_if_failed(motion);
}

void Supervisor::wait_for_motion(const std::function<void(double)>& on_progress) {
  double deadline = monotonic_now() + timing_.stall;
  double progress = 0;
  Motion motion = robot_.motion();
  while (motion.state == Motion::State::kMoving) {
    end_if_stalled(deadline);
    sleep_and_watch();
    motion = robot_.motion();
    if (motion.progress > progress) deadline = monotonic_now() + timing_.stall;
    progress = std::max(progress, motion.progress);
    on_progress(progress);
  }
  end_if_failed(motion);
  moving_ = false;
}

void Supervisor::arm(double rate, const Lighting& lighting) {
  watch();
  armed_ = true;  // set before: a circuit that did not answer may have received it
  on(Outcome::kTriggerLost, [&] { trigger_.arm(rate, lighting); });
}

Disarmed Supervisor::disarm() noexcept {
  if (!armed_) return {};
  armed_ = false;
  return trigger_.disarm();
}

void Supervisor::stop_robot() noexcept {
  if (moving_) robot_.stop();
  moving_ = false;
}

void Supervisor::end_if_failed(const Motion& motion) {
  switch (motion.state) {
    case Motion::State::kMoving:
    case Motion::State::kReached:
      return;
    case Motion::State::kFailed:
    case Motion::State::kStopped:
      throw EndEarly{Outcome::kMotionFailed, motion.message};
    case Motion::State::kLost:
      throw EndEarly{Outcome::kRobotLost, motion.message};
  }
}

void Supervisor::end_if_stalled(double deadline) const {
  if (monotonic_now() < deadline) return;
  throw EndEarly{
      Outcome::kMotionFailed,
      fmt::format("the robot has not moved for {:g} s; check drives, override and obstacles",
                  timing_.stall)};
}

void Supervisor::end_if_unseen() {
  const std::string unseen = armed_ && moving_ ? robot_.unseen() : "";
  // At two checks in a row: if this process was held up, the poses waiting for it arrive in
  // between.
  if (!unseen.empty() && unseen_before_) throw EndEarly{Outcome::kRobotLost, unseen};
  unseen_before_ = !unseen.empty();
}

void Supervisor::sleep_and_watch() {
  std::this_thread::sleep_for(std::chrono::duration<double>(timing_.poll));
  watch();
}

bool Supervisor::wait_for(double time, const std::function<bool()>& condition) {
  const double deadline = monotonic_now() + time;
  watch();
  while (!condition()) {
    if (monotonic_now() >= deadline) return false;
    sleep_and_watch();
  }
  return true;
}

void Supervisor::watch() {
  const std::string why_to_cancel = why_to_cancel_();
  if (!why_to_cancel.empty()) throw EndEarly{Outcome::kCancelled, why_to_cancel};
  for (const Watched& watched : watched_) {
    const std::string trouble = watched.device->trouble();
    if (!trouble.empty()) throw EndEarly{watched.outcome, trouble};
  }
  end_if_unseen();
  if (armed_ && monotonic_now() - last_keep_alive_ >= timing_.keep_alive) {
    trigger_.keep_alive();
    last_keep_alive_ = monotonic_now();
  }
}

}  // namespace scan_cell
