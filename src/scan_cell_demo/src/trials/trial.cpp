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
constexpr double kMillisecond = 1e3;  // [ms] per second

/// Which node dies; empty: none.
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
      break;
  }
  return "";
}

}  // namespace

const std::vector<Blow>& every_blow() {
  static const std::vector<Blow> blows = {Blow::kEmergencyStop,    Blow::kCablePulled,
                                          Blow::kControllerKilled, Blow::kDriverKilled,
                                          Blow::kCellKilled,       Blow::kVideeKilled};
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
  }
  return "";
}

std::string name_of(Moment moment) {
  return moment == Moment::kMidMove ? "mid move" : "mid scan";
}

TrialBench::TrialBench(RunningCell& cell, const LaserTap& tap, std::string folder,
                       std::uint16_t videe, double max_on)
    : cell_(cell), tap_(tap), folder_(std::move(folder)), videe_(videe), max_on_(max_on) {}

void TrialBench::begin(const Trial& trial, const std::string& name) {
  constexpr int kMaxTries = 3;
  for (int tries = 1;; ++tries) {
    cell_.wait_until_well();
    cell_.wait_until_standing();
    if (trial.blow == Blow::kVideeKilled) {
      cell_.start_videe_scan(videe_);
    } else {
      cell_.start_scan(name);
    }
    try {
      cell_.wait_for_step(trial.moment == Moment::kMidScan ? kStepOfCapture : kStepOfMove,
                          trial.share);
      return;
    } catch (const EndedBefore&) {
      ++begun_anew_;
      if (tries == kMaxTries) throw;
    }
  }
}

TrialResult TrialBench::make(const Trial& trial, const std::string& name) {
  begin(trial, name);
  const bool scanning = trial.moment == Moment::kMidScan;
  TrialResult result;
  if (scanning && !tap_.wait_until_on(kPatience)) result.failures.push_back("no laser in the scan");
  const std::uint64_t switched_on = tap_.switched_on();
  const Nanoseconds struck = strike(trial.blow);
  const auto on = tap_.on_for(struck, kPatience);
  result.lasers_on = on.value_or(kPatience);
  if (result.lasers_on > max_on_)
    result.failures.push_back(
        fmt::format("lasers on for {:.1f} ms", kMillisecond * result.lasers_on));
  check_end(trial, result);
  make_well(trial);
  const double way = cell_.way_within(kWatch);
  if (way > kMaxWay) result.failures.push_back(fmt::format("moved by {:g} m", way));
  if (tap_.switched_on() != switched_on) result.failures.push_back("lasers went on again");
  for (std::string& file : broken_files())
    result.failures.push_back(std::move(file));
  return result;
}

Nanoseconds TrialBench::strike(Blow blow) {
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

void TrialBench::check_end(const Trial& trial, TrialResult& result) {
  const auto scan = cell_.end();
  if (!scan) {
    result.outcome = "no result";
    if (trial.blow != Blow::kCellKilled) result.failures.push_back("the cell went away");
    return;
  }
  result.outcome = scan->message;
  if (scan->outcome == scan_cell_msgs::ScanResult::FINISHED)
    result.failures.push_back("the scan was reported as whole");
  if (trial.moment == Moment::kMidScan) check_cloud(*scan, result);
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
