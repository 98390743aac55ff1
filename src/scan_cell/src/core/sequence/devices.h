// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "tecnogamma_camera/peak_profile.h"

namespace scan_cell {

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

  /// Starts to move the flange along a line; returns once the goal was handed over.
  /// @param flange pose of tool0 in the robot's base frame
  /// @param camera_rate [Hz] frame rate told to the controller with the motion; 0: none
  virtual void start_move(const Eigen::Isometry3d& flange, double camera_rate) = 0;

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
  /// Profiles on external trigger. trouble() watches for profiles from expect_profiles() on.
  virtual void start() = 0;
  virtual void expect_profiles(double rate) = 0;
  virtual void stop() noexcept = 0;
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
  std::uint64_t pulses =
      0;                //!< since arm(): by its own count where it answers, or else those heard
  std::string trouble;  //!< why it may not have pulsed to the end; empty where it answered
};

/// Which lasers are on with the pulses.
struct Lighting {
  std::uint8_t lasers = 0;  //!< mask, bit 0: laser_0
  bool alternate = false;   //!< both take turns, pulse by pulse, laser_0 first
};

/// The trigger circuit with the lasers.
class Trigger : public Device {
 public:
  virtual void arm(double rate, const Lighting& lighting) = 0;

  /// Pulses stop, lasers go off. Never throws.
  virtual Disarmed disarm() noexcept = 0;

  /// Tells the circuit that somebody still watches; without it the lasers go off.
  virtual void keep_alive() = 0;
};

/// What happens to the data: binder and triangulation.
class Stages : public Device {
 public:
  virtual void start(const std::string& scan_id) = 0;

  /// Waits for frames and poses that are late, and makes the audit of all that was captured.
  /// @param pulses sent in the scan
  /// @param patience [s] the longest to wait
  /// @return how many of the last pulses have no frame
  virtual std::uint64_t bind(std::uint64_t pulses, double patience) = 0;

  /// Makes the cloud of all that was bound, also where bind() failed.
  /// @param whole the scan did not end early: its cloud may go on to preprocessing
  virtual void triangulate(bool whole, double patience) = 0;
};

}  // namespace scan_cell
