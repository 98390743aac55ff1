// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell_sim/controller/controller.h"

namespace scan_cell_sim {

/// Sets a fault's number in WireFaults from the value that a person writes: milliseconds, or a
/// share.
/// @throw scan_cell_common::InvalidParameter if there is none of this name
void set_fault(WireFaults& faults, const std::string& name, double value);

/// Operates the controller's panel and its cable by lines of text.
class Panel {
 public:
  /// @param faults the controller's at the start
  Panel(Controller& controller, const ControllerFaults& faults)
      : controller_(controller), faults_(faults) {}

  /// Carries out one line and returns the result, or the help for an unknown command.
  std::string carry_out(const std::string& line);

 private:
  using Words = std::vector<std::string>;

  std::string perform(Words words);
  void change_fault(const Words& words);
  std::string tell() const;

  Controller& controller_;
  ControllerFaults faults_;
};

}  // namespace scan_cell_sim
