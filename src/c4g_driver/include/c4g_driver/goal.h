// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "c4g_driver/robot_state.h"

namespace c4g_driver {

/// How near the measured end of a motion must be to its target.
struct ArrivalTolerance {
  double position = 1e-3;  //!< [m]
  double angle = 5e-3;     //!< [rad] of the flange, or of each joint
};

/// The motion requested last, and how it ended. A goal that has ended stays ended, whatever comes
/// later.
class Goal {
 public:
  /// How a motion ended, or that it has not ended.
  enum class Outcome { kNone, kUnderway, kReached, kStopped, kLinkLost, kFailed };
  /// A pose of the flange in base_link [m], or six joints [rad].
  using Target = std::variant<Eigen::Isometry3d, Joints>;

  Goal() = default;
  /// @param motion its number on the controller
  Goal(std::uint64_t motion, const Target& target, const ArrivalTolerance& tolerance);

  /// Takes a state from the controller; states of other motions change nothing.
  void update(const RobotState& state);

  /// Ends the goal if it is in progress.
  void end(Outcome outcome, const std::string& message);

  Outcome outcome() const { return outcome_; }                      //!< at this moment
  bool underway() const { return outcome_ == Outcome::kUnderway; }  //!< whether it is in progress
  double progress() const { return progress_; }                     //!< 0 .. 1
  /// Of a tool path, the waypoint passed or reached last, counted from 0.
  std::uint64_t waypoint() const { return waypoint_; }
  const std::string& message() const { return message_; }  //!< why it ended

 private:
  std::string missed_by(const RobotState& state) const;

  std::uint64_t motion_ = 0;
  Target target_;
  ArrivalTolerance tolerance_;
  Outcome outcome_ = Outcome::kNone;
  double progress_ = 0;
  std::uint64_t waypoint_ = 0;
  std::string message_;
};

}  // namespace c4g_driver
