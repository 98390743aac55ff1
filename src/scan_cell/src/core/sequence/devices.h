// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scan_cell/scan_request.h"
#include "scan_cell/scan_run.h"
#include "tecnogamma_camera/peak_profile.h"

namespace scan_cell {

/// A motion that is not begun yet.
struct PlannedMove {
  MoveTarget target;
  double speed = 0;        //!< [m/s]
  double camera_rate = 0;  //!< [Hz] told to the controller with it; 0: none
};

/// How far the robot could get in several motions.
struct MovesCheck {
  std::size_t possible = 0;              //!< of the first motions
  std::string refusal;                   //!< why not the one after those; empty: all are possible
  std::optional<Eigen::Vector3d> place;  //!< [m] of the flange there, in the robot's base frame
};

/// How the motion that was started last stands.
struct Motion {
  enum class State {
    kMoving,
    kReached,
    kFailed,   //!< refused, or not carried out
    kStopped,  //!< by the controller or by somebody else
    kLost,
  };
  State state = State::kMoving;
  double progress = 0;  //!< 0 .. 1
  std::string message;  //!< why it did not get there
};

/// What all devices have in common. Calls that cannot be carried out throw a
/// scan_cell_common::Error.
class Device {
 public:
  virtual ~Device() = default;

  /// Why the device cannot be relied on at this moment; empty while all is well.
  virtual std::string trouble() const = 0;
};

/// The robot, through its driver.
class Robot : public Device {
 public:
  /// Linear motion with linear interpolation, at this speed of the flange [m/s].
  virtual void set_linear_motion(double speed) = 0;

  /// Whether it could carry out motions, each from where the one before ends and the first from
  /// where it stands; nothing moves.
  /// @return none where its driver cannot tell
  virtual std::optional<MovesCheck> check(const std::vector<PlannedMove>& moves) = 0;

  /// Starts to move the flange; returns once the goal was handed over.
  /// @param camera_rate [Hz] frame rate told to the controller with the motion; 0: none
  virtual void start_move(const MoveTarget& target, double camera_rate) = 0;

  virtual Motion motion() const = 0;

  /// Why nobody knows where it is in the motion under way; empty while its poses come. Asked only
  /// while it moves with a laser on, when trouble() would tell too late.
  virtual std::string unseen() const = 0;

  /// Why it could not move now, such as a pressed emergency stop; empty while it could.
  virtual std::string hindrance() const = 0;

  /// Pose of tool0 in the robot's base frame, asked of the controller while it stands still.
  /// @throw scan_cell_common::Error, also while it moves
  virtual Eigen::Isometry3d static_pose() = 0;

  /// Stops and drops the goal. Never throws: it is called when things go wrong.
  virtual void stop() noexcept = 0;
};

/// The camera, through its driver.
class Camera : public Device {
 public:
  /// Profiles on external trigger, with these settings; what they leave out is as it was before.
  /// Where the settings change, frames that are on their way still count as exposed before.
  /// @throw scan_cell_common::Refused if it cannot be set so
  virtual void start(const PassCamera& settings) = 0;

  /// [s] as it was started; 0 where it does not tell
  virtual double exposure() const = 0;

  /// From here on trouble() watches for profiles.
  /// @param rate [Hz] 0: none are expected any more
  virtual void expect_profiles(double rate) = 0;
  virtual void stop() noexcept = 0;

  /// Undoes the settings of start().
  /// @return why they could not be undone; empty: they were, or none were made
  virtual std::string restore() noexcept = 0;
};

/// One frame: the image and the laser line that was found in it.
struct Snapshot {
  cv::Mat image;  //!< 8 or 16 bit grey, the whole sensor
  tecnogamma_camera::PeakProfile peaks;
};

/// The camera as it takes single frames of the whole sensor, a pulse of the trigger each.
class SnapshotCamera {
 public:
  virtual ~SnapshotCamera() = default;

  /// Makes it read out the whole sensor, and remembers what it was set to.
  virtual void prepare() = 0;

  /// From here on the next pulse's frame is waited for.
  /// @param exposure [s]
  virtual void start(double exposure) = 0;

  /// The first whole frame since start(), once it is there.
  virtual std::optional<Snapshot> snapshot() = 0;

  /// Neither throws: they are called when things go wrong.
  virtual void stop() noexcept = 0;

  /// Undoes prepare(), which may have failed half way.
  /// @return why it could not be undone; empty: it was
  virtual std::string restore() noexcept = 0;
};

/// How a trigger circuit left off.
struct Disarmed {
  std::uint32_t arming = 0;  //!< its number
  std::uint64_t pulses = 0;  //!< in it: by its own count where it answers, or else those heard
  std::string trouble;       //!< why it may not have pulsed to the end; empty where it answered
};

/// The trigger circuit with the lasers.
class Trigger : public Device {
 public:
  /// Whether arm() would take it now; nothing is switched on.
  /// @return false where its node cannot tell
  /// @throw scan_cell_common::Refused with the reason why not
  virtual bool check(double rate, const Lighting& lighting) = 0;

  /// @param rate [Hz] of the pulses
  virtual void arm(double rate, const Lighting& lighting) = 0;

  /// Pulses stop, lasers go off. Never throws.
  virtual Disarmed disarm() noexcept = 0;

  /// Tells the circuit that somebody still watches; without it the lasers go off.
  virtual void keep_alive() = 0;
};

/// The pulses of one arming of the trigger.
struct ArmingPulses {
  std::uint32_t arming = 0;  //!< its number
  std::uint64_t pulses = 0;  //!< sent in it
};

/// What happens to the data: binder and triangulation.
class Stages : public Device {
 public:
  virtual void start(const std::string& scan_id) = 0;

  /// Whether start_run() would take it; nothing is begun.
  /// @throw scan_cell_common::Refused such as for a laser that is not calibrated
  virtual void check_run(const ScanRun& run) = 0;

  /// What is pulsed from here on belongs to this run.
  virtual void start_run(const ScanRun& run) = 0;

  /// Waits for frames and poses that are late, and makes the audit of all that was captured.
  /// @param armings of the scan, in their order
  /// @param patience [s] the longest to wait
  /// @return how many of the last pulses of each arming have no frame
  virtual std::vector<std::uint64_t> bind(const std::vector<ArmingPulses>& armings,
                                          double patience) = 0;

  /// Makes the cloud of all that was bound, also where bind() failed.
  /// @param whole the scan did not end early: its cloud may go on to preprocessing
  virtual void triangulate(bool whole, double patience) = 0;

  /// After triangulate(): why the passes make no single surface; empty where they do.
  virtual std::string disagreement() const { return ""; }
};

}  // namespace scan_cell
