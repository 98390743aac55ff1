// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "scan_cell_sim/controller/controller_options.h"
#include "scan_cell_sim/controller/motion_state.h"
#include "scan_cell_sim/flange_motion.h"

namespace scan_cell_sim {

/// Emulator of a robot controller that serves C4G (c4g_protocol.md) over UDP, with a Comau
/// Smart5 SiX. It runs in its own thread from construction to destruction, and knows the true pose
/// of the flange at every instant. All methods are safe to call from any thread.
class Controller : public FlangeMotion {
 public:
  /// Starts in the start posture: flange at (0.80, 0, 0.60) m in base_link, looking straight down
  /// with its x along the base's x.
  /// @throw scan_cell_common::InvalidParameter if the address is not an IPv4 address, or the stream
  /// period or a fault is out of range
  /// @throw scan_cell_common::ConnectionError if the port is taken
  explicit Controller(const ControllerOptions& options);
  ~Controller() override;

  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  std::uint16_t port() const;  //!< it listens on

  /// True pose of tool0 in base_link at an instant of the host's clock. Future instants follow
  /// the current motion.
  Eigen::Isometry3d flange_at(scan_cell_common::Nanoseconds host) const override;

  /// True digital outputs at an instant of the host's clock; bit n: output n + 1 is on.
  std::uint32_t outputs_at(scan_cell_common::Nanoseconds host) const;

  /// The true state now.
  MotionState state() const;
  std::uint64_t motions_begun() const;  //!< since its start

  /// The instant [host clock] at which the controller's clock showed `t` [us], since its start.
  scan_cell_common::Nanoseconds host_time(std::int64_t t) const;

  /// Replaces the previous faults.
  /// @throw scan_cell_common::InvalidParameter
  void set_faults(const ControllerFaults& faults);

  /// Switches the controller off and on again: for `dark` seconds it neither receives nor sends.
  /// The robot brakes, the session is lost, settings and alarms are reset, the clock restarts. The
  /// mode selector and the emergency stop keep their positions. Afterwards somebody switches the
  /// drives on.
  /// @throw scan_cell_common::InvalidParameter if `dark` is negative
  void restart(double dark);

  // Actions of somebody at the controller's panel. After an emergency stop or an alarm: release the
  // button, reset the alarms, switch the drives on. The motion does not resume.

  void press_e_stop();    //!< the robot brakes, the drives go off
  void release_e_stop();  //!< moves nothing
  /// Changing the mode switches the drives off.
  void select(ControllerMode mode);
  /// In mode programming, drives are on as long as somebody holds the enabling device.
  /// @throw ControllerRefusal while the emergency stop is pressed or an alarm is active
  void switch_drives(bool on);
  /// @throw ControllerRefusal while the emergency stop is pressed
  void reset_alarms();

  /// Raises an alarm, as of a collision or a following error. It ends the current motion in an
  /// error.
  void fail_motion(const std::string& text);

  static Joints start_posture();  //!< [rad]

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace scan_cell_sim
