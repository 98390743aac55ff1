// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "coverage.h"
#include "scan_cell/scan_program.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/tools/tool_main.h"
#include "simulated_scan.h"

namespace {

std::vector<Eigen::Vector3d> read_points(const std::string& file) {
  std::vector<Eigen::Vector3d> points;
  for (const pcl::PointXYZ& point : scan_cell_common::load_cloud(file))
    points.emplace_back(point.getVector3fMap().cast<double>());
  return points;
}

void print(const pass_planner::Coverage& coverage) {
  const scan_cell_sim::CloudError& error = coverage.error;
  std::printf("%zu points; from the true surfaces: RMS %.3f mm, farthest %.3f mm\n", error.points,
              1e3 * error.rms, 1e3 * error.max);
  std::printf("surface that the program can see, with a scanned point within %g mm:\n",
              1e3 * pass_planner::kThere);
  std::printf("%20s %8s %8s %12s\n", "up to [deg]", "places", "there", "up to here");
  for (const pass_planner::AngleCoverage& one : coverage.by_angle) {
    const double there =
        static_cast<double>(one.there) / static_cast<double>(std::max<std::size_t>(one.places, 1));
    std::printf("%20.0f %8zu %6.1f %% %10.1f %%\n", one.max_angle * 180 / M_PI, one.places,
                100 * there, 100 * coverage.share(one.max_angle));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "How much of the surface that a scan program can see is in its cloud, by the worse of the "
      "angles of light and sight to the surface's normal");
  std::string program, world, cloud;
  app.add_option("--program", program, "scan program: YAML, in world")->required();
  app.add_option("--world", world, "of the simulated cell: YAML")->required();
  app.add_option("--cloud", cloud,
                 "of the running cell; without it, the passes are rendered, 0.6 mm apart");
  return scan_cell_common::tool_main("bench_coverage", app, argc, argv, [&] {
    const auto scanner = scan_cell_common::load_scanner_model(SCANNER_FILE);
    const auto passes = scan_cell::load_scan_program(program).passes;
    const auto scene = scan_cell_sim::load_world(world);
    print(pass_planner::measure_coverage(
        scene, passes, scanner,
        cloud.empty()
            ? simulated_scan(scan_cell_sim::Scene(scene), scanner, pass_planner::sweeps_of(passes))
            : read_points(cloud)));
    return 0;
  });
}
