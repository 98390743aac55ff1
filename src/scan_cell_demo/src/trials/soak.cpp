// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Scans with the simulated cell in a loop, with faults on its wires. Switches the controller off in
// every tenth scan, and records the resources of each node: memory, threads, files and sockets.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <map>

#include "running_cell/nodes.h"
#include "running_cell/running_cell.h"
#include "running_cell/started_cell.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/node_process.h"
#include "scan_cell_common/tools/tool_main.h"
#include "trials/growth.h"

using namespace scan_cell_demo;  // NOLINT

namespace {

constexpr double kHour = 3600;  // [s]
constexpr int kStepOfCapture = 6;
constexpr int kRestarts = 10;  // one scan in this many has the controller switched off and on
constexpr double kOff = 0.5;   // [s]

struct Options {
  double hours = 1;
  double report = 60;  //!< [s] between two lines of progress
  std::string folder = "out/soak";
};

scan_cell_msgs::SetFaults::Request wire_faults(unsigned seed) {
  scan_cell_msgs::SetFaults::Request faults;
  faults.robot_lost_packets = 0.1;
  faults.robot_repeated_packets = 0.1;
  faults.robot_delayed_packets = 0.1;
  faults.robot_held = 0.002;
  faults.robot_flipped = 0.02;
  faults.robot_truncated = 0.02;
  faults.robot_requests_too = 1;
  faults.camera_lost_frames = 0.01;
  faults.camera_lost_packets = 0.001;
  faults.seed = seed;
  return faults;
}

class Soak {
 public:
  explicit Soak(const Options& options) : options_(options) {}

  int run() {
    const ros::WallTime begin = ros::WallTime::now();
    double reported = 0, seconds = 0;
    while ((seconds = (ros::WallTime::now() - begin).toSec()) < options_.hours * kHour) {
      scan();
      sample();
      if (seconds - reported < options_.report) continue;
      reported = seconds;
      print_progress(seconds);
    }
    return print_verdict();
  }

 private:
  void scan() {
    cell_.wait_until_well();
    cell_.set_faults(wire_faults(static_cast<unsigned>(++scans_)));
    cell_.start_scan(fmt::format("soak_{}", scans_));
    if (scans_ % kRestarts == 0) restart_controller();
    const auto result = cell_.end();
    if (result && result->outcome == scan_cell_msgs::ScanResult::FINISHED) return;
    std::printf("scan %d ended early: %s\n", scans_,
                result ? result->message.c_str() : "no result");
    ++early_;
  }

  void restart_controller() {
    try {
      cell_.wait_for_step(kStepOfCapture, 0.5);
    } catch (const EndedBefore&) {
      return;
    }
    scan_cell_msgs::SetFaults::Request faults = wire_faults(static_cast<unsigned>(scans_));
    faults.robot_restart = kOff;
    cell_.set_faults(faults);
  }

  void sample() {
    ros::V_string nodes;
    ros::master::getNodes(nodes);
    for (const std::string& node : nodes) {
      if (node == ros::this_node::getName()) continue;
      const auto process = scan_cell_common::process_of(node);
      if (process) samples_[node].push_back(holdings_of(*process));
    }
  }

  void print_progress(double seconds) const {
    std::printf("%.0f of %.0f min, %d scans, %d ended early;", seconds / 60, options_.hours * 60,
                scans_, early_);
    for (const auto& [node, samples] : samples_) {
      const Holdings& now = samples.back();
      std::printf(" %s %.1f MB %d threads %d files %d sockets;", node.c_str(), now.memory,
                  now.threads, now.files, now.sockets);
    }
    std::printf("\n");
    std::fflush(stdout);
  }

  int print_verdict() const {
    std::printf("%-28s %9s %9s %9s\n", "", "first", "half way", "last");
    bool flat = true;
    for (const auto& [node, samples] : samples_) {
      const std::string grown = growth(samples);
      flat = flat && grown.empty();
      const Holdings &first = samples.front(), &half = samples[samples.size() / 2],
                     &last = samples.back();
      std::printf(
          "%-28s %6.1f MB %6.1f MB %6.1f MB  threads %d %d %d  files %d %d %d  sockets %d "
          "%d %d  %s%s\n",
          node.c_str(), first.memory, half.memory, last.memory, first.threads, half.threads,
          last.threads, first.files, half.files, last.files, first.sockets, half.sockets,
          last.sockets, grown.empty() ? "flat" : "GROWS:", grown.c_str());
    }
    std::printf("%d scans, %d ended early: %s\n", scans_, early_, flat ? "flat" : "NOT flat");
    return flat ? 0 : scan_cell_common::kRefused;
  }

  const Options& options_;
  RunningCell cell_{ros::NodeHandle()};
  int scans_ = 0;
  int early_ = 0;
  std::map<std::string, std::vector<Holdings>> samples_;
};

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app(
      "Scans in a loop with faults on the wires, and checks that no node's memory, threads, files "
      "and sockets keep growing");
  app.add_option("--hours", options.hours, "duration")->check(CLI::PositiveNumber);
  app.add_option("--report", options.report, "seconds between two lines of progress");
  app.add_option("--folder", options.folder, "folder for logs");
  return scan_cell_common::tool_main("soak", app, argc, argv, [&] {
    const StartedCell cell("soak", {LAUNCH_FILE, "sim:=true"}, options.folder);
    return Soak(options).run();
  });
}
