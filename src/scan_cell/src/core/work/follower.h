// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "work/work_plan.h"

namespace scan_cell {

/// What the robot's driver says about a path before anything moves.
struct FollowCheck {
  std::string refusal;        //!< the first fault; empty: the robot can follow it
  std::vector<double> start;  //!< [rad] joints at the first waypoint
};

/// A robot that follows whole tool paths. Robot::motion() of the same robot reports the motion.
class Follower {
 public:
  virtual ~Follower() = default;

  /// Nothing moves. @throw scan_cell_common::Error if its driver cannot tell
  virtual FollowCheck check_follow(const WorkPlan& plan) = 0;

  /// From here on, joints move at this share of their own speed, until restore_speed().
  virtual void set_joint_speed(double share) = 0;

  /// Never throws, since it is also called on failures.
  virtual void restore_speed() noexcept = 0;

  /// Starts to move all joints together to these angles [rad].
  virtual void start_joints(const std::vector<double>& joints) = 0;

  /// Starts to follow the path; the tip must stand at its first waypoint.
  virtual void start_follow(const WorkPlan& plan) = 0;

  /// The waypoint passed last on the path being followed.
  virtual std::size_t passed() const = 0;
};

}  // namespace scan_cell
