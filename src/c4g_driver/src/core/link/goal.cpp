// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/goal.h"

#include <sstream>

namespace c4g_driver {

namespace {

std::string reason_of(const RobotState& state, const char* otherwise) {
  return state.error && !state.error->text.empty() ? state.error->text.c_str() : otherwise;
}

}  // namespace

Goal::Goal(std::uint64_t motion, const Target& target, const ArrivalTolerance& tolerance)
    : motion_(motion), target_(target), tolerance_(tolerance), outcome_(Outcome::Underway) {}

void Goal::update(const RobotState& state) {
  if (!underway() || state.motion != motion_) return;
  progress_ = state.progress;
  switch (state.status) {
    case MotionStatus::Idle:
    case MotionStatus::Moving:
      return;
    case MotionStatus::Arrived: {
      const std::string missed = missed_by(state);
      end(missed.empty() ? Outcome::Reached : Outcome::Failed, missed);
      return;
    }
    case MotionStatus::Stopped:
      end(Outcome::Stopped, reason_of(state, "stopped"));
      return;
    case MotionStatus::Error:
      end(Outcome::Failed, reason_of(state, "the controller gives no reason"));
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
  std::ostringstream text;
  text << "the controller says it arrived, " << position << " m and " << angle
       << " rad from the target";
  return text.str();
}

}  // namespace c4g_driver
