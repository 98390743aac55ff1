// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

namespace scan_cell {

/// How the motion that was started last stands.
struct Motion {
  enum class State { Moving, Reached, Failed, Lost };
  State state = State::Moving;
  double progress = 0;  //!< 0 .. 1
  std::string message;  //!< why it failed or was lost
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

/// The trigger circuit with the lasers.
class Trigger : public Device {
 public:
  virtual void arm(double rate, std::uint8_t lasers) = 0;

  /// Pulses stop, lasers go off. Never throws.
  /// @return pulses sent since arm(), by the count of the circuit where it answers, or else of the
  /// events that arrived
  virtual std::uint64_t disarm() noexcept = 0;

  /// Tells the circuit that somebody still watches; without it the lasers go off.
  virtual void keep_alive() = 0;
};

/// What happens to the data: binder and triangulation.
class Stages : public Device {
 public:
  virtual void start(const std::string& scan_id) = 0;

  /// Waits for what is under way, and makes audit and whole cloud of all that was captured.
  /// @param pulses sent in the scan
  /// @param patience [s] the longest to wait for data that is late
  virtual void finish(std::uint64_t pulses, double patience) = 0;
};

}  // namespace scan_cell
