// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "running_cell/followed_path.h"
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
  kVideeKilled,  //!< while its own client scans
  kStop,         //!< no fault: the client cancels the scan
};
/// When the blow comes: on the way to the start of a line with the lasers off, during the scan of
/// the line, at any time in a program of three passes, or while the tool follows a path with an
/// output on.
enum class Moment { kMidMove, kMidScan, kMidProgram, kMidPath };

const std::vector<Blow>& every_blow();
/// The blows possible while a path is followed; the cell and videe_node have no part in that.
const std::vector<Blow>& every_blow_in_a_path();
std::string name_of(Blow blow);
std::string name_of(Moment moment);

/// One blow and its moment.
struct Trial {
  Blow blow = Blow::kEmergencyStop;
  Moment moment = Moment::kMidScan;
  double share = 0.5;  //!< 0 .. 1 of the motion done before; of a program, of its time
  double pause = 2;    //!< [s] duration of the blow: until the button or the cable is back
};

/// The cell's reaction. `failures` is empty if the cell kept every promise.
struct TrialResult {
  std::optional<double> on;           //!< [s] after the blow, until no laser, or in a path no
                                      //!< output of the tool, was on any more; none: not measured
  std::optional<double> moving;       //!< [s] after the blow, in a path; none: not measured
  std::string place;                  //!< where in the scan the blow came
  std::string outcome;                //!< message of the scan's or path's result
  std::vector<std::string> failures;  //!< broken promises
};

/// Limits of a trial.
struct TrialLimits {
  double on = 0.1;      //!< [s] that lasers, or the tool, may be on after a blow
  double moving = 0.5;  //!< [s] that the robot may still move after a blow in a path
};

/// Runs trials on a running cell and checks its promises: the lasers and the tool go off in time
/// and stay off, the robot stops and does not move again after recovery, and files are whole and
/// stay unchanged.
class TrialBench {
 public:
  /// @param folder where the cell writes a file for each cloud
  /// @param videe port of videe_node
  TrialBench(RunningCell& cell, const LaserTap& tap, std::string folder, std::uint16_t videe,
             const TrialLimits& limits);

  /// Waits until the cell is ready, runs the trial, and leaves the cell without a fault. Retries if
  /// the scan ends by itself before the blow, as on a machine that is too busy.
  /// @throw EndedBefore if that happens three times
  /// @throw scan_cell_common::Error if the cell does not become ready
  TrialResult make(const Trial& trial, const std::string& name);

  int begun_anew() const { return begun_anew_; }

  /// Files that are broken, or changed or removed after they were first seen whole.
  std::vector<std::string> broken_files();

 private:
  TrialResult make_in_path(const Trial& trial);
  TrialResult make_in_scan(const Trial& trial);
  void check_rest(const Trial& trial, scan_cell_common::Nanoseconds struck, TrialResult& result);
  void begin(const Trial& trial, const std::string& name);
  void begin_once(const Trial& trial, const std::string& name);
  double time_of_program();

  /// @return host time just before the blow
  scan_cell_common::Nanoseconds strike(const Trial& trial);
  void make_well(const Trial& trial);
  void check_end(const Trial& trial, const RunningCell::Step& struck_at, TrialResult& result);
  void check_cloud(const scan_cell_msgs::ScanResult& scan, TrialResult& result);
  static void check_passes(const scan_cell_msgs::ScanResult& scan,
                           const RunningCell::Step& struck_at, TrialResult& result);

  RunningCell& cell_;
  const LaserTap& tap_;
  const std::string folder_;
  const std::uint16_t videe_;
  const TrialLimits limits_;
  FollowedPath path_;
  std::string killed_node_;
  pid_t killed_ = -1;
  int begun_anew_ = 0;
  double time_of_program_ = 0;                   // [s] 0: not measured yet
  std::map<std::string, std::uintmax_t> files_;  // whole clouds and their sizes [bytes]
};

}  // namespace scan_cell_demo
