// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/goal.h"

#include <fmt/format.h>

namespace c4g_driver {

namespace {

std::string reason_of(const RobotState& state, const char* otherwise) {
  return state.error && !state.error->text.empty() ? state.error->text.c_str() : otherwise;
}

}  // namespace

Goal::Goal(std::uint64_t motion, const Target& target, const ArrivalTolerance& tolerance)
    : motion_(motion), target_(target), tolerance_(tolerance), outcome_(Outcome::kUnderway) {}

void Goal::update(const RobotState& state) {
  if (!underway() || state.motion != motion_) return;
  progress_ = state.progress;
  waypoint_ = state.waypoint;
  switch (state.status) {
    case MotionStatus::kIdle:
    case MotionStatus::kMoving:
      return;
    case MotionStatus::kArrived: {
      const std::string missed = missed_by(state);
      end(missed.empty() ? Outcome::kReached : Outcome::kFailed, missed);
      return;
    }
    case MotionStatus::kStopped:
      end(Outcome::kStopped, reason_of(state, "stopped"));
      return;
    case MotionStatus::kError:
      end(Outcome::kFailed, reason_of(state, "the controller gives no reason"));
      return;
  }
}

void Goal::end(Outcome outcome, const std::string& message) {
  if (!underway()) return;
  outcome_ = outcome;
  message_ = message;
}

std::string Goal::missed_by(const RobotState& state) const {
  double position = 0;
  double angle = 0;
  if (const auto* flange = std::get_if<Eigen::Isometry3d>(&target_)) {
    position = (state.flange.translation() - flange->translation()).norm();
    angle = Eigen::AngleAxisd(flange->linear().transpose() * state.flange.linear()).angle();
  } else {
    angle = (state.joints - std::get<Joints>(target_)).cwiseAbs().maxCoeff();
  }
  if (position <= tolerance_.position && angle <= tolerance_.angle) return "";
  return fmt::format("the controller reports arrival, {:g} m and {:g} rad from the target",
                     position, angle);
}

}  // namespace c4g_driver
