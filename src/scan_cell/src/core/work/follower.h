// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "work/work_plan.h"

namespace scan_cell {

/// What the robot's driver says of a path before anything moves.
struct FollowCheck {
  std::string refusal;        //!< the first fault; empty: the robot can follow it
  std::vector<double> start;  //!< [rad] joints at the first waypoint
};

/// A robot that follows whole paths of its tool. How the motion stands is told by
/// Robot::motion() of the same robot.
class Follower {
 public:
  virtual ~Follower() = default;

  /// Nothing moves. @throw scan_cell_common::Error if its driver cannot tell
  virtual FollowCheck check_follow(const WorkPlan& plan) = 0;

  /// From here on joints move at this share of their own speed, until restore_speed().
  virtual void set_joint_speed(double share) = 0;

  /// Never throws: it is called when things go wrong, too.
  virtual void restore_speed() noexcept = 0;

  /// Goes to angles of the joints [rad], all together.
  virtual void start_joints(const std::vector<double>& joints) = 0;

  /// Follows the path; the tip stands at its first waypoint.
  virtual void start_follow(const WorkPlan& plan) = 0;

  /// Of the path that is followed: the last waypoint that was passed.
  virtual std::size_t passed() const = 0;
};

}  // namespace scan_cell
