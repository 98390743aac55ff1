// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "bag_scan.h"
#include "laser_triangulation/triangulator.h"
#include "poses/pose_log.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/tools/tool_main.h"
#include "time_offset/time_offset.h"

namespace {

using namespace pose_frame_binder;  // NOLINT

struct Options {
  std::string forward;
  std::string backward;
  std::string scanner;
  BagTopics topics;
  Frames frames;
  Settings settings;
  laser_triangulation::PeakLimits limits;
  TimeOffsetSettings offset;
  scan_cell_common::ParameterOptions typed;
};

/// Reads points in the flange's frame and poses in the base's frame, so that static transforms do
/// not matter.
UnboundScan read(const std::string& path, const Options& options) {
  rosbag::Bag bag;
  open(bag, path, rosbag::bagmode::Read);
  ProfileBinder binder(options.settings, options.frames, Eigen::Isometry3d::Identity());
  laser_triangulation::Triangulator triangulator(
      scan_cell_common::load_scanner_model(options.scanner), options.limits);
  UnboundScan scan;
  std::vector<laser_triangulation::ScanPoint> points;
  feed(bag, options.topics, binder, [&] {
    for (const scan_cell_msgs::BoundProfileConstPtr& bound : binder.take()) {
      const scan_cell_msgs::PeakProfile& profile = bound->profile;
      points.clear();
      triangulator.add({profile.laser, profile.first_row, profile.position.size(),
                        profile.position.data(), profile.width.data(), profile.intensity.data()},
                       Eigen::Isometry3d::Identity(), points);
      UnboundScan::Line& line = scan.lines.emplace_back();
      line.time = static_cast<Nanoseconds>(bound->header.stamp.toNSec());
      for (const laser_triangulation::ScanPoint& point : points)
        line.points.push_back(Eigen::Vector3f(point.x, point.y, point.z).cast<double>());
    }
  });
  const PoseLog& poses = binder.binder().poses();
  for (std::size_t i = 0; i < poses.size(); ++i)
    scan.poses.push_back(poses[i]);
  std::cout << path << ": " << summary(binder.binder().audit()) << '\n';
  return scan;
}

void run(const Options& options) {
  const TimeOffset found = estimate_time_offset(read(options.forward, options),
                                                read(options.backward, options), options.offset);
  constexpr double kMilliseconds = 1e3, kMicrometres = 1e6;  // in a second, in a metre
  std::printf(
      "pose_delay: %.4f ms, standard deviation %.4f ms (from the posterior %.4f, from the "
      "residuals "
      "%.4f)\n%zu points in common, %zu of them on slopes along the motion; the scans lie %.1f um "
      "apart, and %.1f um with the delay taken out\nset ~pose_delay: %.7f\n",
      found.pose_delay * kMilliseconds, found.uncertainty * kMilliseconds,
      found.from_posterior * kMilliseconds, found.from_residuals * kMilliseconds, found.pairs,
      found.on_relief, found.apart_before * kMicrometres, found.apart_after * kMicrometres,
      options.settings.pose_delay + found.pose_delay);
}

void declare(CLI::App& app, Options& options) {
  app.add_option("--forward", options.forward, "recorded scan")->required();
  app.add_option("--backward", options.backward,
                 "recorded scan of the same scene, in the opposite direction")
      ->required();
  app.add_option("--scanner", options.scanner, "scanner model, YAML")->required();
  app.add_option("--events", options.topics.events, "topic")->capture_default_str();
  app.add_option("--profiles", options.topics.profiles, "topic")->capture_default_str();
  app.add_option("--poses", options.topics.poses, "topic")->capture_default_str();
  options.typed.add(app, options.frames, {"base_frame", "flange_frame"});
  options.typed.add(app, options.settings, {"camera_latency", "pose_delay"});
  app.add_option("--max-delay", options.offset.max_delay, "[s] longest delay that is looked for")
      ->capture_default_str();
  app.add_option("--max-distance", options.offset.max_distance,
                 "[m] largest distance between the scans")
      ->capture_default_str();
  options.typed.add(app, options.limits, {"min_range", "max_range"});
  scan_cell_common::refuse_renamed(
      app, {{"--most-delay", "--max-delay"}, {"--most-distance", "--max-distance"}});
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Finds how late the robot's poses are stamped, from two scans there and back");
  Options options;
  declare(app, options);
  return scan_cell_common::tool_main("estimate_time_offset", app, argc, argv, [&] {
    options.typed.read(options.frames);
    options.typed.read(options.settings);
    options.typed.read(options.limits);
    run(options);
    return 0;
  });
}
