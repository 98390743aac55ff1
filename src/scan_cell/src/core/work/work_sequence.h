// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "sequence/devices.h"
#include "sequence/sequence_end.h"
#include "sequence/supervisor.h"
#include "work/follower.h"

namespace scan_cell {

/// Is told of the progress of the work.
class WorkObserver {
 public:
  virtual ~WorkObserver() = default;
  /// @param doing such as "approach" @param progress 0 .. 1, of the whole
  virtual void on_progress(const std::string& doing, double progress) = 0;
  /// A waypoint of the plan was passed.
  virtual void on_passed(const WorkWaypoint& waypoint) = 0;
};

/// Runs a path: checks whether the robot can follow it, moves to its start by the joints, and
/// follows it. It ends early if the robot is stopped or lost, or if it is cancelled: then the robot
/// brakes on the path, its outputs go off, and nothing continues by itself. The lasers stay off.
class WorkSequence {
 public:
  /// @param robot, follower the same robot
  WorkSequence(Robot& robot, Follower& follower, Trigger& trigger, WorkObserver& observer,
               const Supervisor::Timing& timing);

  /// Runs the whole work in the calling thread.
  SequenceEnd run(const WorkPlan& plan, const WhyToCancel& why_to_cancel);

 private:
  void work(const WorkPlan& plan);
  void refuse_what_hinders();
  void tell_passed(const WorkPlan& plan);

  Robot& robot_;
  Follower& follower_;
  WorkObserver& observer_;
  Supervisor supervisor_;
  std::size_t told_ = 0;  // waypoints of the plan reported to the observer
};

}  // namespace scan_cell
