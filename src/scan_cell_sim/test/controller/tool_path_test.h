// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "controller/arm_truth.h"
#include "controller/motion/motion_control.h"
#include "scan_cell_sim/controller/controller.h"

/// A path of the tool followed by the emulated arm, sampled every millisecond of its own time.

constexpr double kStep = 1e-3;  // [s]

/// What the robot did at an instant.
struct Sample {
  double time;  // [s] since it began
  Eigen::Vector3d tip;
  Eigen::Matrix3d turn;
  scan_cell_sim::MotionState state;
};

/// A tool that points sideways, so that its turning moves the flange.
inline Eigen::Isometry3d crooked_tool() {
  Eigen::Isometry3d tool = Eigen::Isometry3d::Identity();
  tool.translation() << 0.04, -0.02, 0.15;
  tool.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 0).normalized()));
  return tool;
}

class ToolPaths : public testing::Test {
 protected:
  using Waypoints = std::vector<scan_cell_sim::TipWaypoint>;

  /// Pose of the tip at the start, with the tool as it is turned there.
  Eigen::Isometry3d start() const {
    return scan_cell_sim::flange_of(scan_cell_sim::Controller::start_posture()) * tool_;
  }

  /// Adds a waypoint, a step [mm] from the one before, with speed [mm/s], zone [mm] and outputs.
  void add(double x, double y, double z, double speed, double zone, std::uint32_t outputs = 0,
           double turn = 0) {
    if (waypoints_.empty()) waypoints_.push_back({start(), 0.05, 0, 0});
    scan_cell_sim::TipWaypoint next{waypoints_.back().tip, speed * 1e-3, zone * 1e-3, outputs};
    next.tip.translation() += 1e-3 * Eigen::Vector3d(x, y, z);
    next.tip.rotate(Eigen::AngleAxisd(turn, axis_));
    waypoints_.push_back(next);
  }

  void begin(std::size_t from = 0) { control_.follow(7, tool_, waypoints_, from, kStart); }

  scan_cell_common::Nanoseconds instant(double seconds) const {
    return kStart + scan_cell_common::from_seconds(seconds);
  }

  /// The sample at a time, with the tip computed from the joints, so that these are tested too.
  Sample at(double seconds) const {
    const auto state = control_.state(instant(seconds));
    const Eigen::Isometry3d tip = product_of_exponentials(state.joints) * tool_;
    return {seconds, tip.translation(), tip.linear(), state};
  }

  /// Samples until the robot stands.
  std::vector<Sample> all() const {
    std::vector<Sample> samples{at(0)};
    while (samples.back().state.status == scan_cell_sim::MotionStatus::kMoving &&
           samples.size() < 100000)
      samples.push_back(at(static_cast<double>(samples.size()) * kStep));
    return samples;
  }

  double off_the_lines(const Eigen::Vector3d& tip) const {
    double least = 1;
    for (std::size_t i = 1; i < waypoints_.size(); ++i) {
      const Eigen::Vector3d from = waypoints_[i - 1].tip.translation();
      const Eigen::Vector3d way = waypoints_[i].tip.translation() - from;
      const double share =
          std::clamp((tip - from).dot(way) / std::max(way.squaredNorm(), 1e-12), 0.0, 1.0);
      least = std::min(least, (tip - from - share * way).norm());
    }
    return least;
  }

  /// [m] distance of the tip from the zones; negative inside a zone.
  double outside_zones(const Eigen::Vector3d& tip, double margin = 0) const {
    double least = 1;
    for (const auto& waypoint : waypoints_)
      least = std::min(least, (tip - waypoint.tip.translation()).norm() - waypoint.zone - margin);
    return least;
  }

  void expect_on_the_path(const std::vector<Sample>& samples) const {
    constexpr double kPlace = 0.05e-3, kRounding = 1e-7;  // [m]
    for (const Sample& sample : samples) {
      const double off = off_the_lines(sample.tip);
      EXPECT_TRUE(off < kPlace || outside_zones(sample.tip) < kRounding)
          << sample.time << " s: " << off * 1e3 << " mm";
    }
  }

  scan_cell_sim::MotionControl control_{scan_cell_sim::Controller::start_posture()};
  Eigen::Isometry3d tool_ = crooked_tool();
  Eigen::Vector3d axis_ = Eigen::Vector3d(0, 1, 2).normalized();  // that add() turns about
  Waypoints waypoints_;
};
