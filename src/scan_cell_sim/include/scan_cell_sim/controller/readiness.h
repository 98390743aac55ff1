// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell_sim/controller/refusal.h"

namespace scan_cell_sim {

/// Position of the mode selector; c4g_protocol.md says what each mode allows.
enum class ControllerMode { kProgramming, kAutomatic, kRemote };

/// @throw ControllerRefusal
ControllerMode controller_mode_of(const std::string& name);
const char* name_of(ControllerMode mode);  //!< as the protocol writes it

/// Whether the controller can move, and if not, why: mode selector, drives, emergency stop, alarms.
/// Nothing here moves or stops a robot. Not safe for use from several threads.
class Readiness {
 public:
  /// Who asks: somebody at the controller's panel, or a client on the network.
  enum class Source { kPanel, kClient };

  ControllerMode mode() const { return mode_; }                     //!< where the selector stands
  bool e_stop() const { return e_stop_; }                           //!< pressed
  bool drives() const { return drives_; }                           //!< on
  const std::vector<Complaint>& alarms() const { return alarms_; }  //!< oldest first

  /// @throw ControllerRefusal unless a client may begin a motion
  void require_motion() const;

  /// A change of the mode switches the drives off.
  void select(ControllerMode mode);

  /// Forgets the alarms, except the emergency stop if it is pressed; otherwise the drives are on.
  void restart();

  void press_e_stop();  //!< the drives go off
  /// The alarm stays active and the drives stay off.
  void release_e_stop() { e_stop_ = false; }

  /// Switches the drives off. Nothing moves until the alarm is reset.
  void raise(const Complaint& alarm);

  /// @throw ControllerRefusal while the emergency stop is pressed, or if a client must not
  void reset_alarms(Source source);

  /// Switching off is always granted.
  /// @throw ControllerRefusal while the drives must stay off, or if a client must not
  void switch_drives(bool on, Source source);

 private:
  void require_right(Source source, const std::string& what) const;

  ControllerMode mode_ = ControllerMode::kRemote;
  bool e_stop_ = false;
  bool drives_ = true;
  std::vector<Complaint> alarms_;
};

}  // namespace scan_cell_sim
