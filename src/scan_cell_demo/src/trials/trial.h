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
  kEmergencyStop,
  kCablePulled,
  kControllerKilled,
  kDriverKilled,
  kCellKilled,
  kVideeKilled,  //!< while a scan of its own client runs
  kStop,         //!< nothing breaks: its client cancels the scan
};
/// When: on the way to the start of a line with the lasers off, while the line is scanned, or at
/// any time in a program of three passes.
enum class Moment { kMidMove, kMidScan, kMidProgram };

const std::vector<Blow>& every_blow();
std::string name_of(Blow blow);
std::string name_of(Moment moment);

/// One blow and its moment within the motion.
struct Trial {
  Blow blow = Blow::kEmergencyStop;
  Moment moment = Moment::kMidScan;
  double share = 0.5;  //!< 0 .. 1 of the motion done by then; of a program, of its time
  double pause = 2;    //!< [s] the blow lasts: until the button or the cable is back
};

/// How the cell reacted. `failures` is empty if it kept every promise.
struct TrialResult {
  double lasers_on = 0;               //!< [s] after the blow, until none was on any more
  std::string place;                  //!< where in the scan the blow came
  std::string outcome;                //!< message of the scan's result
  std::vector<std::string> failures;  //!< promises that were broken
};

/// Runs trials on a running cell and checks its promises: the lasers go off in time and stay off,
/// the robot stops and does not move again after recovery, and files are whole and stay unchanged.
class TrialBench {
 public:
  /// @param folder where the cell writes a file for each cloud
  /// @param videe port of videe_node
  /// @param max_on [s] that lasers may be on after a blow
  TrialBench(RunningCell& cell, const LaserTap& tap, std::string folder, std::uint16_t videe,
             double max_on);

  /// Waits until the cell is ready, runs the trial, and leaves the cell without a fault. Starts
  /// again if the scan ends by itself before the blow, as on a machine that is too busy.
  /// @throw EndedBefore if that happens three times
  /// @throw scan_cell_common::Error if the cell does not become ready
  TrialResult make(const Trial& trial, const std::string& name);

  int begun_anew() const { return begun_anew_; }

  /// Files that are broken, or were changed or removed since they were first seen whole.
  std::vector<std::string> broken_files();

 private:
  void begin(const Trial& trial, const std::string& name);
  void begin_once(const Trial& trial, const std::string& name);
  double time_of_program();

  /// @return host time just before the blow
  scan_cell_common::Nanoseconds strike(Blow blow);
  void make_well(const Trial& trial);
  void check_end(const Trial& trial, const RunningCell::Step& struck_at, TrialResult& result);
  void check_cloud(const scan_cell_msgs::ScanResult& scan, TrialResult& result);
  static void check_passes(const scan_cell_msgs::ScanResult& scan,
                           const RunningCell::Step& struck_at, TrialResult& result);

  RunningCell& cell_;
  const LaserTap& tap_;
  const std::string folder_;
  const std::uint16_t videe_;
  const double max_on_;
  std::string killed_node_;
  pid_t killed_ = -1;
  int begun_anew_ = 0;
  double time_of_program_ = 0;                   // [s] 0: not measured yet
  std::map<std::string, std::uintmax_t> files_;  // whole clouds and their sizes [bytes]
};

}  // namespace scan_cell_demo
