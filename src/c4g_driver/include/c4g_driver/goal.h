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

/// The motion that was asked for last, and how it ended. A goal that ended stays so: nothing that
/// comes later brings it back.
class Goal {
 public:
  /// How a motion ended, or that it has not.
  enum class Outcome { kNone, kUnderway, kReached, kStopped, kLinkLost, kFailed };
  /// A pose of the flange in base_link [m], or six joints [rad].
  using Target = std::variant<Eigen::Isometry3d, Joints>;

  Goal() = default;
  /// @param motion its number on the controller
  Goal(std::uint64_t motion, const Target& target, const ArrivalTolerance& tolerance);

  /// Takes what the controller says; states of other motions change nothing.
  void update(const RobotState& state);

  /// Ends it, if it is under way.
  void end(Outcome outcome, const std::string& message);

  Outcome outcome() const { return outcome_; }                      //!< of this moment
  bool underway() const { return outcome_ == Outcome::kUnderway; }  //!< whether it has not ended
  double progress() const { return progress_; }                     //!< 0 .. 1
  /// Of a path of the tool, the last one that was passed or reached, counted from 0.
  std::uint64_t waypoint() const { return waypoint_; }
  const std::string& message() const { return message_; }  //!< why it ended so

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
