// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "running_cell/laser_tap.h"
#include "running_cell/running_cell.h"

namespace scan_cell_demo {

/// What happens to the cell.
enum class Blow {
  EmergencyStop,
  CablePulled,
  ControllerKilled,
  DriverKilled,
  CellKilled,
  VideeKilled  //!< which had the scan started for a client of its own
};
/// When: on the way to the start of a line with the lasers off, or while the line is scanned.
enum class Moment { MidMove, MidScan };

const std::vector<Blow>& every_blow();
std::string name_of(Blow blow);
std::string name_of(Moment moment);

/// One blow, and where in the motion it falls.
struct Trial {
  Blow blow = Blow::EmergencyStop;
  Moment moment = Moment::MidScan;
  double share = 0.5;  //!< 0 .. 1 of the motion that is over by then
  double pause = 2;    //!< [s] the blow lasts: until the button or the cable is back
};

/// How the cell took it. All is well where `failures` is empty.
struct TrialResult {
  double lasers_on = 0;               //!< [s] after the blow
  std::string outcome;                //!< what the cell said
  std::vector<std::string> failures;  //!< promises that were broken
};

/// Makes trials of a running cell and holds it to its promises: lasers off in time and no more
/// after that, no motion when all is well again, whole files that stay as they are, and a robot
/// that stopped on its way.
class TrialBench {
 public:
  /// @param folder in which the cell leaves a file of each cloud
  /// @param videe port on which videe_node serves
  /// @param most_on [s] that lasers may be on after a blow
  TrialBench(RunningCell& cell, const LaserTap& tap, std::string folder, std::uint16_t videe,
             double most_on);

  /// Waits for a cell that is well, makes the trial, and leaves the cell without a fault. Begins
  /// anew where the scan ends by itself before the blow, as on a machine that is too busy.
  /// @throw EndedBefore if it does so three times
  /// @throw scan_cell_common::Error if the cell does not come to be well
  TrialResult make(const Trial& trial, const std::string& name);

  int begun_anew() const { return begun_anew_; }

  /// Files that are gone or changed since they were first seen whole, and those that are not.
  std::vector<std::string> broken_files();

 private:
  void begin(const Trial& trial, const std::string& name);

  /// @return host time just before it falls
  scan_cell_common::Nanoseconds strike(Blow blow);
  void make_well(const Trial& trial);
  void check_end(const Trial& trial, TrialResult& result);
  void check_cloud(const scan_cell_msgs::ScanResult& scan, TrialResult& result);

  RunningCell& cell_;
  const LaserTap& tap_;
  const std::string folder_;
  const std::uint16_t videe_;
  const double most_on_;
  std::string killed_node_;
  pid_t killed_ = -1;
  int begun_anew_ = 0;
  std::map<std::string, std::uintmax_t> files_;  // whole clouds and their sizes [bytes]
};

}  // namespace scan_cell_demo
