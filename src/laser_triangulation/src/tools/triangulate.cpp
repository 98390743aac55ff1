// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "cloud_builder.h"
#include "cloud_file.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/ros/bag_errors.h"
#include "scan_cell_common/scanner/point_deviations.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

struct Options {
  std::string bag;
  std::string topic = "/pose_frame_binder/bound_profiles";
  std::string scanner;
  std::string output;
  std::string units = "m";
  laser_triangulation::PeakLimits limits;
  scan_cell_common::ParameterOptions typed;
};

/// @return exit code: refused if the passes disagree
int triangulate(const Options& options) {
  using laser_triangulation::CloudBuilder;
  using scan_cell_msgs::BoundProfile;
  constexpr std::size_t kMaxPoints = 500'000'000;  // 18 GB; chosen
  laser_triangulation::check_ply_output(options.output);
  const double unit = scan_cell_common::metres_per(options.units);
  CloudBuilder builder(scan_cell_common::load_scanner_model(options.scanner), options.limits,
                       kMaxPoints, scan_cell_common::load_point_deviations(options.scanner));
  scan_cell_common::name_bag_in_errors(options.bag, [&] {
    const rosbag::Bag bag(options.bag, rosbag::bagmode::Read);
    rosbag::View view(bag, rosbag::TopicQuery(options.topic));
    for (const rosbag::MessageInstance& message : view) {
      const auto profile = message.instantiate<BoundProfile>();
      if (profile) builder.add(*profile);
    }
  });
  if (builder.points().empty()) {
    throw scan_cell_common::UnusableInput(options.bag, "no points (" + builder.summary() + ")",
                                          "check that " + options.topic + " has bound profiles");
  }
  builder.bring_together();
  laser_triangulation::save_ply(options.output, builder.points(), unit);
  std::cout << builder.summary() << '\n';
  const scan_cell_msgs::CloudStatistics statistics = builder.statistics("");
  for (const std::string& line : CloudBuilder::agreement_lines(statistics))
    std::cout << line << '\n';
  if (statistics.agreement != scan_cell_msgs::CloudStatistics::DISAGREE) return 0;
  std::cerr << "triangulate: the passes disagree; " << options.output
            << " contains them as captured\n";
  return scan_cell_common::kRefused;
}

}  // namespace

int main(int argc, char** argv) {
  scan_cell_common::Outputs outputs;
  CLI::App app("Turns the bound profiles of a bag (bind_bag makes one) into a cloud");
  Options options;
  app.add_option("--bag", options.bag, "bag with bound profiles")->required();
  app.add_option("--topic", options.topic, "topic of the bound profiles")->capture_default_str();
  app.add_option("--scanner", options.scanner, "scanner model, YAML")->required();
  outputs.add(app, "--output", options.output, "cloud to write, PLY")->required();
  app.add_option("--units", options.units, "unit of x, y, z in the cloud")
      ->check(CLI::IsMember(scan_cell_common::length_units()))
      ->capture_default_str();
  options.typed.add(app, options.limits);
  return scan_cell_common::tool_main(
      "triangulate", app, argc, argv,
      [&] {
        options.typed.read(options.limits);
        return triangulate(options);
      },
      scan_cell_common::kUnusable, outputs);
}
