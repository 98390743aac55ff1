// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The cloud's error for each method of binding, in the simulated cell on its real interfaces,
// beside the error with the true poses; and the true delay of the poses beside its estimate from
// two scans.
#include <ros/package.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "binding_errors.h"
#include "delay_trial.h"
#include "pose_frame_binder/types.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"
#include "scan_cell_sim/cell.h"

using namespace scan_cell_demo;  // NOLINT

namespace {

constexpr double kMicrometres = 1e6;
using scan_cell_common::kMillimetres;
constexpr double kMilliseconds = 1e3;
constexpr double kFrameRate = 97.3;  // [Hz] so that pulses meet all phases between two poses

std::string sim(const std::string& name) {
  return ros::package::getPath("scan_cell_sim") + "/config/" + name;
}

/// The flange 595 mm above the board, where the light crosses the camera's axis on the board.
Eigen::Isometry3d over_board(double x, double y, double turn, double tilt) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  return Eigen::Translation3d(x, y, 0.595) * AngleAxisd(turn, Vector3d::UnitZ()) *
         AngleAxisd(M_PI, Vector3d::UnitX()) * AngleAxisd(tilt, Vector3d::UnitY());
}

/// Motion along an arc about the robot's first axis, with the line of light along the arm.
Motion arc(double angle, const std::vector<double>& override) {
  const Eigen::Isometry3d base = scan_cell_sim::load_base_link_in_world(sim("cell.yaml"));
  Motion motion;
  motion.target = base * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * base.inverse() *
                  over_board(0, 0, M_PI / 2, 0);
  motion.in_joints = true;
  motion.override = override;
  return motion;
}

/// Motion along x, while the flange turns and tilts.
Motion turning(double x, const std::vector<double>& override) {
  Motion motion;
  motion.target = over_board(x, 0, 1.6 * x, 0.6 * x);
  motion.speed = 0.08;
  motion.acceleration = 0.25;
  motion.override = override;
  return motion;
}

struct Trial {
  const char* name;
  Motion approach;
  Motion motion;
};

std::vector<Trial> trials() {
  constexpr double kReach = 0.2;    // [rad]
  constexpr double kPercent = 5.1;  // [%] 100 mm/s at 0.8 m
  constexpr double kWay = 0.17;     // [m]
  return {
      {"arc", arc(-kReach, {100}), arc(kReach, {kPercent})},
      {"arc, alternating 100 and 40 mm/s", arc(kReach, {100}),
       arc(-kReach, {kPercent, 0.4 * kPercent})},
      {"turning, 0.25 m/s^2", turning(-kWay, {100}), turning(kWay, {100, 30})},
  };
}

void print(const char* rule, const CloudError& error, double perfect, const char* goal,
           const scan_cell_msgs::BindingAudit& audit) {
  std::printf(
      "  %-12s %6.1f um, %.3f times that%s; %.1f um off the perfect cloud; %lu of %lu bound", rule,
      error.to_surface * kMicrometres, error.to_surface / perfect, goal,
      error.to_perfect * kMicrometres, audit.frames_bound, audit.frames);
  std::map<std::uint8_t, int> reasons;
  for (const scan_cell_msgs::DroppedFrame& dropped : audit.dropped)
    ++reasons[dropped.reason];
  for (const auto& [reason, count] : reasons)
    std::printf(", %d %s", count, name(static_cast<pose_frame_binder::DropReason>(reason)));
  std::printf("\n");
}

void print(const char* motion, const std::string& period, const Scan& scan,
           const BindingErrors& errors) {
  const MedianAndMax pulses = pulse_delay(scan);
  std::printf(
      "%s, a pose every %s ms: %zu frames at %.0f mm/s (at most %.0f), %.2f m/s^2 (at most %.1f)\n"
      "  pulses stamped %.3f ms late (worst %.2f), poses %.3f ms later than these\n"
      "  perfect      %6.1f um from the true surface, %zu points\n",
      motion, period.c_str(), errors.frames, errors.speed.median * kMillimetres,
      errors.speed.max * kMillimetres, errors.acceleration.median, errors.acceleration.max,
      pulses.median * kMilliseconds, pulses.max * kMilliseconds,
      true_pose_delay(scan) * kMilliseconds, errors.perfect.to_surface * kMicrometres,
      errors.points);
  const double perfect = errors.perfect.to_surface;
  print("interpolated", errors.interpolated, perfect, " (goal 1.2)", scan.interpolated.audit);
  print("first pose", errors.first_pose, perfect, "", scan.first_pose.audit);
  std::fflush(stdout);
}

void bench_binding(SimulatedCell& cell) {
  const std::string world = sim("reference_frame.yaml");
  const auto scanner = scan_cell_common::load_scanner_model(sim("scanner.yaml"));
  const scan_cell_sim::Scene part(scan_cell_sim::load_world(world), "frame");
  std::printf(
      "cloud error: RMS distance of the points from the frame's true surface, by the poses of "
      "the same frames\n(constant speed is left out: it knows neither curves nor ramps)\n");
  cell.load_world(world);
  for (const std::string period : {"2", "4", "10"}) {
    cell.set_controller_parameter("stream_period", period);
    for (const Trial& trial : trials()) {
      cell.move(trial.approach);
      const Scan scan = cell.scan(trial.motion, kFrameRate);
      print(trial.name, period, scan, compare(scan, scanner, {}, part));
    }
  }
  cell.set_controller_parameter("stream_period", "4");
}

Motion line(double x) {
  Motion motion;
  motion.target = over_board(x, 0, 0, 0);
  motion.speed = 0.1;
  return motion;
}

void bench_delay(SimulatedCell& cell) {
  constexpr double kWay = 0.17;  // [m]
  std::printf("delay of the poses, estimated from two scans there and back\n");
  cell.load_world(sim("box_on_edge.yaml"));
  for (const double delay : {0.0, 0.008, 0.02}) {
    cell.delay_controller(delay);
    cell.move(line(-kWay));
    const DelayTrial trial =
        try_delay(cell, line(kWay), line(-kWay), kFrameRate, sim("scanner.yaml"));
    std::printf(
        "sent %.0f ms late by the controller: true delay of the poses %.3f ms, estimate %.3f ms, "
        "standard deviation %.3f ms, off by %.1f of them\n",
        delay * kMilliseconds, trial.truth * kMilliseconds, trial.estimate * kMilliseconds,
        trial.uncertainty * kMilliseconds, (trial.estimate - trial.truth) / trial.uncertainty);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("The error of a cloud by the method of binding, in the simulated cell.");
  return scan_cell_common::tool_main("bench_cloud_error", app, argc, argv, [] {
    double load[1] = {0};
    getloadavg(load, 1);
    std::printf("load before the run %.1f\n", load[0]);
    SimulatedCell cell(LAUNCH_FILE);
    bench_binding(cell);
    bench_delay(cell);
    return 0;
  });
}
