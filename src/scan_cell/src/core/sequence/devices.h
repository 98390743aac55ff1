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

/// A motion that has not begun yet.
struct PlannedMove {
  MoveTarget target;
  double speed = 0;        //!< [m/s]
  double camera_rate = 0;  //!< [Hz] sent to the controller with it; 0: none
};

/// How far the robot can get in several motions.
struct MovesCheck {
  std::size_t possible = 0;              //!< number of the first motions that are possible
  std::string refusal;                   //!< why the next one is not; empty: all are possible
  std::optional<Eigen::Vector3d> place;  //!< [m] of the flange there, in the robot's base frame
};

/// Status of the motion started last.
struct Motion {
  enum class State {
    kMoving,
    kReached,
    kFailed,   //!< refused, or not carried out
    kStopped,  //!< by the controller or by another client
    kLost,
  };
  State state = State::kMoving;
  double progress = 0;  //!< 0 .. 1
  std::string message;  //!< why it did not arrive
};

/// Base of all devices. Calls that cannot be carried out throw a scan_cell_common::Error.
class Device {
 public:
  virtual ~Device() = default;

  /// Why the device is not reliable at this moment; empty while all is well.
  virtual std::string trouble() const = 0;
};

/// The robot, through its driver.
class Robot : public Device {
 public:
  /// Sets linear motion with linear interpolation, at this speed of the flange [m/s].
  virtual void set_linear_motion(double speed) = 0;

  /// Whether the robot could carry out motions, each from the end of the one before and the first
  /// from where it stands; nothing moves.
  /// @return none if its driver cannot tell
  virtual std::optional<MovesCheck> check(const std::vector<PlannedMove>& moves) = 0;

  /// Starts to move the flange; returns once the goal has been sent.
  /// @param camera_rate [Hz] frame rate sent to the controller with the motion; 0: none
  virtual void start_move(const MoveTarget& target, double camera_rate) = 0;

  virtual Motion motion() const = 0;

  /// Why the robot's position in the present motion is unknown; empty while its poses arrive. Only
  /// called while it moves with a laser on, when trouble() would report too late.
  virtual std::string unseen() const = 0;

  /// Why the robot could not move now, such as a pressed emergency stop; empty if it could.
  virtual std::string hindrance() const = 0;

  /// Pose of tool0 in the robot's base frame, read from the controller while the robot stands.
  /// @throw scan_cell_common::Error, also while it moves
  virtual Eigen::Isometry3d static_pose() = 0;

  /// Stops and drops the goal. Never throws, since it is called on failures.
  virtual void stop() noexcept = 0;
};

/// The camera, through its driver.
class Camera : public Device {
 public:
  /// Starts profiles on external trigger with these settings; what they leave out stays as before.
  /// If the settings change, frames in transit still count as exposed before.
  /// @throw scan_cell_common::Refused if these settings are not possible
  virtual void start(const PassCamera& settings) = 0;

  /// [s] as started; 0 if the camera does not report it
  virtual double exposure() const = 0;

  /// From here on trouble() watches for profiles.
  /// @param rate [Hz] 0: no more are expected
  virtual void expect_profiles(double rate) = 0;
  virtual void stop() noexcept = 0;

  /// Undoes the settings of start().
  /// @return why they could not be undone; empty: they were, or there were none
  virtual std::string restore() noexcept = 0;
};

/// One frame: the image and the laser line found in it.
struct Snapshot {
  cv::Mat image;  //!< 8 or 16 bit grey, the whole sensor
  tecnogamma_camera::PeakProfile peaks;
};

/// The camera taking single frames of the whole sensor, one per trigger pulse.
class SnapshotCamera {
 public:
  virtual ~SnapshotCamera() = default;

  /// Sets the camera to read out the whole sensor, and remembers its settings.
  virtual void prepare() = 0;

  /// From here on waits for the next pulse's frame.
  /// @param exposure [s]
  virtual void start(double exposure) = 0;

  /// The first whole frame since start(), once it has arrived.
  virtual std::optional<Snapshot> snapshot() = 0;

  /// Neither stop() nor restore() throws, since they are called on failures.
  virtual void stop() noexcept = 0;

  /// Undoes prepare(), which may have failed half-way.
  /// @return why it could not be undone; empty: it was
  virtual std::string restore() noexcept = 0;
};

/// How an arming of the trigger ended.
struct Disarmed {
  std::uint32_t arming = 0;  //!< its number
  std::uint64_t pulses = 0;  //!< in it: by the trigger's own count if it answers, else those heard
  std::string trouble;       //!< why it may not have pulsed to the end; empty if it answered
};

/// The trigger circuit with the lasers.
class Trigger : public Device {
 public:
  /// Checks whether arm() would accept it now; nothing is switched on.
  /// @return false if its node cannot tell
  /// @throw scan_cell_common::Refused with the reason if it would not
  virtual bool check(double rate, const Lighting& lighting) = 0;

  /// @param rate [Hz] of the pulses
  virtual void arm(double rate, const Lighting& lighting) = 0;

  /// Stops the pulses and switches the lasers off. Never throws.
  virtual Disarmed disarm() noexcept = 0;

  /// Tells the circuit that the cell is still watched; without it the lasers go off.
  virtual void keep_alive() = 0;
};

/// The pulses of one arming of the trigger.
struct ArmingPulses {
  std::uint32_t arming = 0;  //!< its number
  std::uint64_t pulses = 0;  //!< sent in it
};

/// The processing of the data: binder and triangulation.
class Stages : public Device {
 public:
  virtual void start(const std::string& scan_id) = 0;

  /// Checks whether start_run() would accept it; nothing begins.
  /// @throw scan_cell_common::Refused, for example for a laser that is not calibrated
  virtual void check_run(const ScanRun& run) = 0;

  /// Pulses from here on belong to this run.
  virtual void start_run(const ScanRun& run) = 0;

  /// Waits for late frames and poses, and makes the audit of everything captured.
  /// @param armings of the scan, in their order
  /// @param patience [s] the longest to wait
  /// @return for each arming, how many of the last pulses have no frame
  virtual std::vector<std::uint64_t> bind(const std::vector<ArmingPulses>& armings,
                                          double patience) = 0;

  /// Makes the cloud of everything that was bound, even if bind() failed.
  /// @param whole whether the scan did not end early, so that its cloud may go on to preprocessing
  virtual void triangulate(bool whole, double patience) = 0;

  /// After triangulate(): why the passes do not make a single surface; empty if they do.
  virtual std::string disagreement() const { return ""; }
};

}  // namespace scan_cell
