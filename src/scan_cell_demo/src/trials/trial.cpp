// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "trials/trial.h"

#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <thread>

#include "running_cell/nodes.h"
#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"

namespace scan_cell_demo {

namespace fs = std::filesystem;
using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;

namespace {

constexpr double kPatience = 20;  // [s]
constexpr double kWatch = 1.5;    // [s] in which no motion may start
constexpr double kMaxWay = 1e-4;  // [m] of a robot that stands still
constexpr int kStepOfMove = 2;    // of a scan
constexpr int kStepOfCapture = 6;
constexpr int kStepAfterPasses = 8;   // the one between is over at once
constexpr double kMillisecond = 1e3;  // [ms] per second

/// The node killed; empty: none.
std::string victim(Blow blow) {
  switch (blow) {
    case Blow::kControllerKilled:
      return "/scan_cell_sim";
    case Blow::kDriverKilled:
      return "/c4g_driver";
    case Blow::kCellKilled:
      return "/scan_cell";
    case Blow::kVideeKilled:
      return "/videe";
    case Blow::kEmergencyStop:
    case Blow::kCablePulled:
    case Blow::kStop:
      break;
  }
  return "";
}

}  // namespace

const std::vector<Blow>& every_blow() {
  static const std::vector<Blow> blows = {
      Blow::kEmergencyStop, Blow::kCablePulled, Blow::kControllerKilled,
      Blow::kDriverKilled,  Blow::kCellKilled,  Blow::kVideeKilled,
      Blow::kStop};
  return blows;
}

const std::vector<Blow>& every_blow_in_a_path() {
  static const std::vector<Blow> blows = {Blow::kEmergencyStop, Blow::kCablePulled,
                                          Blow::kControllerKilled, Blow::kDriverKilled,
                                          Blow::kStop};
  return blows;
}

std::string name_of(Blow blow) {
  switch (blow) {
    case Blow::kEmergencyStop:
      return "emergency stop";
    case Blow::kCablePulled:
      return "cable pulled";
    case Blow::kControllerKilled:
      return "controller killed";
    case Blow::kDriverKilled:
      return "driver killed";
    case Blow::kCellKilled:
      return "cell killed";
    case Blow::kVideeKilled:
      return "videe killed";
    case Blow::kStop:
      return "stop";
  }
  return "";
}

std::string name_of(Moment moment) {
  switch (moment) {
    case Moment::kMidMove:
      return "mid move";
    case Moment::kMidScan:
      return "mid scan";
    case Moment::kMidProgram:
      return "mid program";
    case Moment::kMidPath:
      return "mid path";
  }
  return "";
}

TrialBench::TrialBench(RunningCell& cell, const LaserTap& tap, std::string folder,
                       std::uint16_t videe, const TrialLimits& limits)
    : cell_(cell),
      tap_(tap),
      folder_(std::move(folder)),
      videe_(videe),
      limits_(limits),
      path_(ros::NodeHandle(), cell.line_in_base()) {}

void TrialBench::begin(const Trial& trial, const std::string& name) {
  constexpr int kMaxTries = 3;
  for (int tries = 1;; ++tries) {
    cell_.wait_until_well();
    cell_.wait_until_standing();
    try {
      begin_once(trial, name);
      return;
    } catch (const EndedBefore&) {
      ++begun_anew_;
      if (tries == kMaxTries) throw;
    }
  }
}

void TrialBench::begin_once(const Trial& trial, const std::string& name) {
  if (trial.moment == Moment::kMidPath) {
    path_.start();
    path_.wait_for_share(trial.share);
    return;
  }
  if (trial.moment == Moment::kMidProgram) {
    const double time = time_of_program();
    cell_.start_program(name);
    cell_.wait_in_scan(trial.share * time);
    return;
  }
  if (trial.blow == Blow::kVideeKilled) {
    cell_.start_videe_scan(videe_);
  } else {
    cell_.start_scan(name);
  }
  cell_.wait_for_step(trial.moment == Moment::kMidScan ? kStepOfCapture : kStepOfMove, trial.share);
}

/// [s] from the goal to the end of the last pass, measured on a whole scan.
double TrialBench::time_of_program() {
  if (time_of_program_ > 0) return time_of_program_;
  const Nanoseconds start = host_now();
  cell_.start_program("whole_program");
  cell_.wait_for_step(kStepAfterPasses, 0);
  const double time = scan_cell_common::to_seconds(host_now() - start);
  const auto scan = cell_.end();
  if (!scan || scan->outcome != scan_cell_msgs::ScanResult::FINISHED)
    throw EndedBefore("the program", "was not scanned whole", scan ? scan->message : "no result");
  time_of_program_ = time;
  cell_.wait_until_standing();
  return time;
}

TrialResult TrialBench::make(const Trial& trial, const std::string& name) {
  begin(trial, name);
  TrialResult result = trial.moment == Moment::kMidPath ? make_in_path(trial) : make_in_scan(trial);
  const std::uint64_t switched_on = tap_.switched_on();
  const int tool_switched_on = path_.switched_on();
  make_well(trial);
  const double way = cell_.way_within(kWatch);
  if (way > kMaxWay) result.failures.push_back(fmt::format("moved by {:g} m", way));
  if (tap_.switched_on() != switched_on) result.failures.push_back("lasers went on again");
  if (path_.is_on() || path_.switched_on() != tool_switched_on)
    result.failures.push_back("the tool went on again");
  for (std::string& file : broken_files())
    result.failures.push_back(std::move(file));
  return result;
}

TrialResult TrialBench::make_in_path(const Trial& trial) {
  TrialResult result;
  result.place = "the tool on";
  const Nanoseconds struck = strike(trial);
  const auto end = path_.end();
  result.outcome = end ? end->message : "no result";
  if (!end && trial.blow != Blow::kDriverKilled) result.failures.push_back("the driver went away");
  if (end && end->outcome == scan_cell_msgs::FollowResult::REACHED)
    result.failures.push_back("the path was reported as followed");
  if (trial.blow == Blow::kControllerKilled) return result;  // the ground truth died with it
  cell_.wait_until_standing();
  check_rest(trial, struck, result);
  return result;
}

void TrialBench::check_rest(const Trial& trial, Nanoseconds struck, TrialResult& result) {
  const FollowedPath::Rest rest = path_.rest(struck);
  result.on = rest.outputs_on;
  result.moving = rest.moving;
  if (rest.outputs_on > limits_.on)
    result.failures.push_back(fmt::format("the tool on for {:.1f} ms at {:.0f} %",
                                          kMillisecond * rest.outputs_on, 100 * trial.share));
  if (rest.moving > limits_.moving)
    result.failures.push_back(fmt::format("moving for {:.1f} ms", kMillisecond * rest.moving));
}

TrialResult TrialBench::make_in_scan(const Trial& trial) {
  const bool scanning = trial.moment == Moment::kMidScan;
  TrialResult result;
  if (scanning && !tap_.wait_until_on(kPatience)) result.failures.push_back("no laser in the scan");
  const RunningCell::Step step = cell_.step();
  result.place = fmt::format("pass {}, step {}, lasers {}", step.pass, step.step,
                             tap_.lasers() == 0 ? "off" : "on");
  const Nanoseconds struck = strike(trial);
  check_end(trial, step, result);
  // A finished scan switches no laser on; lasers switched on after the blow count as still on.
  result.on = tap_.on_for(struck, kPatience).value_or(kPatience);
  if (*result.on > limits_.on)
    result.failures.push_back(fmt::format("lasers on for {:.1f} ms", kMillisecond * *result.on));
  return result;
}

Nanoseconds TrialBench::strike(const Trial& trial) {
  const Blow blow = trial.blow;
  if (blow == Blow::kStop) {
    const Nanoseconds struck = host_now();
    if (trial.moment == Moment::kMidPath) {
      path_.cancel();
    } else {
      cell_.stop_scan();
    }
    return struck;
  }
  killed_node_ = victim(blow);
  if (!killed_node_.empty()) {
    killed_ = checked_process_of(killed_node_);
    const Nanoseconds struck = host_now();
    kill(killed_, SIGKILL);
    return struck;
  }
  scan_cell_msgs::SetFaults::Request faults;
  faults.robot_e_stop = blow == Blow::kEmergencyStop;
  faults.robot_link_down = blow == Blow::kCablePulled;
  const Nanoseconds struck = host_now();
  cell_.set_faults(faults);
  return struck;
}

void TrialBench::check_end(const Trial& trial, const RunningCell::Step& struck_at,
                           TrialResult& result) {
  const auto scan = cell_.end();
  if (!scan) {
    result.outcome = "no result";
    if (trial.blow != Blow::kCellKilled) result.failures.push_back("the cell went away");
    return;
  }
  result.outcome = scan->message;
  if (scan->outcome == scan_cell_msgs::ScanResult::FINISHED)
    result.failures.push_back("the scan was reported as whole");
  if (trial.blow == Blow::kStop && scan->outcome != scan_cell_msgs::ScanResult::CANCELLED)
    result.failures.push_back("the scan was not reported as cancelled");
  if (trial.moment == Moment::kMidProgram) check_passes(*scan, struck_at, result);
  if (trial.moment == Moment::kMidScan || scan->audit.frames_bound > 0) check_cloud(*scan, result);
}

/// Checks that the passes before the blow are finished, and their pulses are accounted for.
void TrialBench::check_passes(const scan_cell_msgs::ScanResult& scan,
                              const RunningCell::Step& struck_at, TrialResult& result) {
  const std::uint32_t before = struck_at.pass > 0 ? struck_at.pass - 1 : 0;
  if (scan.passes_finished != before && scan.passes_finished != before + 1)
    result.failures.push_back(fmt::format("{} passes finished, after pass {} had begun",
                                          scan.passes_finished, before + 1));
  if (scan.passes_finished > 0 && scan.audit.frames_bound == 0)
    result.failures.push_back("nothing is left of the passes that were finished");
}

void TrialBench::check_cloud(const scan_cell_msgs::ScanResult& scan, TrialResult& result) {
  if (scan.cloud_file.empty()) {
    result.failures.push_back("no file with the captured cloud");
    return;
  }
  const std::string path = fs::path(folder_) / fs::path(scan.cloud_file).filename();
  const std::size_t points = scan_cell_common::load_cloud(path).size();
  if (points != scan.statistics.points || points == 0)
    result.failures.push_back(
        fmt::format("{} has {} of {} points", path, points, scan.statistics.points));
}

void TrialBench::make_well(const Trial& trial) {
  if (trial.blow == Blow::kControllerKilled) {
    wait_for_successor(killed_node_, killed_, kPatience);
  } else {
    cell_.wait_until_standing();  // the motion has ended; none may start again
    std::this_thread::sleep_for(std::chrono::duration<double>(trial.pause));
    if (!killed_node_.empty()) wait_for_successor(killed_node_, killed_, kPatience);
  }
  cell_.wait_until_well();
}

std::vector<std::string> TrialBench::broken_files() {
  std::vector<std::string> broken;
  for (const auto& [path, size] : files_) {
    std::error_code error;
    if (fs::file_size(path, error) != size || error)
      broken.push_back(path + " was changed or removed");
  }
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string path = entry.path();
    if (files_.count(path) > 0) continue;
    try {
      scan_cell_common::load_cloud(path);
      files_[path] = entry.file_size();
    } catch (const scan_cell_common::Error& error) {
      broken.emplace_back(error.what());
    }
  }
  return broken;
}

}  // namespace scan_cell_demo
