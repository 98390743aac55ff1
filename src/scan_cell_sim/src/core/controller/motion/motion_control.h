// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "controller/motion/motion_log.h"
#include "scan_cell_sim/controller/motion_state.h"

namespace scan_cell_sim {

/// Plans and runs motions, one at a time. Anything that ends the robot's readiness (emergency stop,
/// drives off, another mode, an alarm) ends the current motion, and nothing resumes it. In mode
/// programming the flange is never faster than 250 mm/s, on any path. Safe for use from several
/// threads; `now` is host time.
class MotionControl {
 public:
  using Nanoseconds = scan_cell_common::Nanoseconds;

  explicit MotionControl(const Joints& start) : log_(start) {}

  /// @throw ControllerRefusal if it cannot be done; then nothing moves
  void move_to_pose(std::uint64_t motion, const Eigen::Isometry3d& flange, double camera_rate,
                    Nanoseconds now);
  void move_along_arc(std::uint64_t motion, const Eigen::Isometry3d& via,
                      const Eigen::Isometry3d& flange, double camera_rate, Nanoseconds now);
  void move_to_joints(std::uint64_t motion, const Joints& joints, double camera_rate,
                      Nanoseconds now);

  /// @param waypoints at least two after `first`
  void follow(std::uint64_t motion, const Eigen::Isometry3d& flange_to_tip,
              const std::vector<TipWaypoint>& waypoints, std::size_t first, Nanoseconds now);

  /// Brakes along the path, as hard as planned for the motion. Does nothing if the robot stands
  /// still.
  void stop(const std::optional<Complaint>& why, Nanoseconds now);

  /// An alarm that ends the current motion in an error, such as a collision or a following error.
  void fail(const std::string& text, Nanoseconds now);

  /// Stops the robot, and forgets the motion.
  void forget(Nanoseconds now);

  /// The drives lose power like everything else. Then the state is as at the start, except the mode
  /// selector and the emergency stop.
  void power_off(Nanoseconds now);
  void power_on(Nanoseconds now);

  void press_e_stop(Nanoseconds now);
  /// The alarm stays active, the drives stay off.
  void release_e_stop();
  void select(ControllerMode mode, Nanoseconds now);
  /// @throw ControllerRefusal as Readiness
  void switch_drives(bool on, Readiness::Source source, Nanoseconds now);
  void reset_alarms(Readiness::Source source);

  MotionSettings settings() const;
  /// The override acts at once, the rest from the next motion on.
  void set(const MotionSettings& settings, Nanoseconds now);

  MotionState state(Nanoseconds now) const;
  bool follows(Nanoseconds now) const;  // on a tool path, and not braking to a stop
  const MotionLog& log() const { return log_; }

  /// Number of motions begun, for tests.
  std::uint64_t motions_begun() const;

 private:
  Joints standing(Nanoseconds now) const;
  void begin(std::uint64_t motion, const PlannedPath& plan, double camera_rate, Nanoseconds now);
  void brake(double harder, MotionStatus ending, const std::optional<Complaint>& why,
             Nanoseconds now);
  /// Brakes hard if a change of the readiness switches the drives off.
  void cut_power(MotionStatus ending, const Complaint& why, Nanoseconds now,
                 const std::function<void()>& change);
  double cruise() const;
  SpeedProfile profile(double way, double speed) const;

  mutable std::mutex mutex_;
  MotionLog log_;
  MotionSettings settings_;
  PlannedPath plan_;
  double reduced_ = 1;  // [1/s] the plan's speed at which the flange moves at 250 mm/s at most
  MotionStatus ending_ = MotionStatus::kIdle;  // status once the run is over
  std::uint64_t motion_ = 0;
  std::uint64_t begun_ = 0;
  double camera_rate_ = 0;
  Readiness readiness_;
  std::optional<Complaint> why_;
};

}  // namespace scan_cell_sim
