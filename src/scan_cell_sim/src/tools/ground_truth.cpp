// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/ground_truth.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"
#include "scan_cell_sim/tool_paths.h"

namespace {

using namespace scan_cell_sim;
using scan_cell_common::Outputs;

using scan_cell_common::kMillimetre;

struct Options {
  std::string world, reference, object, part, cloud, path, output, json;
  std::size_t points = 20000;
  std::uint64_t seed = 1;
  double noise_mm = 0;
  double spacing_mm = 2;
  std::string units = "m";
};

Scene truth(const Options& options) {
  const World world = load_world(options.world);
  return options.part.empty() ? Scene(world) : Scene(world, options.part);
}

void compare_cloud(const Options& options) {
  const scan_cell_common::Cloud cloud =
      scan_cell_common::load_cloud(options.cloud, scan_cell_common::metres_per(options.units));
  std::vector<Eigen::Vector3d> points;
  points.reserve(cloud.size());
  for (const pcl::PointXYZ& point : cloud)
    points.emplace_back(point.x, point.y, point.z);
  const CloudError error = compare(truth(options), points);
  const nlohmann::json report = {{"points", error.points},
                                 {"rms_mm", error.rms / kMillimetre},
                                 {"mean_mm", error.mean / kMillimetre},
                                 {"max_mm", error.max / kMillimetre}};
  if (!options.json.empty()) {
    scan_cell_common::save_text(options.json, report.dump(2) + "\n");
  }
  std::cout << report.dump() << std::endl;
}

void image_path(const Options& options) {
  const World reference = load_world(options.reference);
  const World object = load_world(options.object);
  save_tool_path(options.output, true_image(reference.part(options.part), object.part(options.part),
                                            load_tool_path(options.path)));
}

void sample_cloud(const Options& options) {
  scan_cell_common::check_cloud_output(options.output);
  scan_cell_common::Cloud cloud;
  for (const Eigen::Vector3d& point :
       sample(truth(options), options.points, options.seed, options.noise_mm * kMillimetre)) {
    cloud.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()),
                       static_cast<float>(point.z()));
  }
  scan_cell_common::save_cloud(options.output, cloud, scan_cell_common::metres_per(options.units));
}

void teach_path(const Options& options) {
  save_tool_path(options.output, crest_path(load_world(options.world).part(options.part),
                                            options.spacing_mm * kMillimetre));
}

void add_units(CLI::App& command, Options& options) {
  command.add_option("--units", options.units, "Of the cloud")
      ->check(CLI::IsMember(scan_cell_common::length_units()))
      ->capture_default_str();
}

/// @param work becomes the action of the given command
void add_commands(CLI::App& app, Options& o, Outputs& outputs, std::function<void()>& work) {
  CLI::App* const cloud = app.add_subcommand(
      "cloud", "Distance of a cloud in the frame world to the true surfaces [mm]");
  cloud->add_option("--world", o.world, "World file")->required();
  cloud->add_option("--part", o.part, "Only this part; default: all parts and the floor");
  cloud->add_option("--cloud", o.cloud, "PLY, PCD, XYZ or CSV")->required();
  add_units(*cloud, o);
  outputs.add(*cloud, "--json", o.json, "Report to write");
  cloud->callback([&] { work = [&o] { compare_cloud(o); }; });

  CLI::App* const path = app.add_subcommand("path", "True image of a tool path on a changed part");
  path->add_option("--reference", o.reference, "World file the path was made in")->required();
  path->add_option("--object", o.object, "World file with the changed part")->required();
  path->add_option("--part", o.part, "The part's name, in both")->required();
  path->add_option("--path", o.path, "CSV of tool poses, z into the surface")->required();
  outputs.add(*path, "--output", o.output, "CSV to write")->required();
  path->callback([&] { work = [&o] { image_path(o); }; });

  CLI::App* const points =
      app.add_subcommand("sample", "Points on the surfaces that are visible from above");
  points->add_option("--world", o.world, "World file")->required();
  points->add_option("--part", o.part, "Only this part; default: all parts and the floor");
  points->add_option("--points", o.points, "Number of points")->capture_default_str();
  points->add_option("--seed", o.seed, "Of the random points")->capture_default_str();
  points->add_option("--noise", o.noise_mm, "Standard deviation along the normal [mm]")
      ->capture_default_str();
  outputs.add(*points, "--output", o.output, "PLY or PCD to write")->required();
  add_units(*points, o);
  points->callback([&] { work = [&o] { sample_cloud(o); }; });

  CLI::App* const teach =
      app.add_subcommand("tool_path", "Tool path around the crest of a frame's moulding");
  teach->add_option("--world", o.world, "World file")->required();
  teach->add_option("--part", o.part, "The frame's name")->required();
  teach->add_option("--spacing", o.spacing_mm, "Between waypoints, at most [mm]")
      ->capture_default_str();
  outputs.add(*teach, "--output", o.output, "CSV to write")->required();
  teach->callback([&] { work = [&o] { teach_path(o); }; });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The simulated world's ground truth: how good is a cloud, where must a path go?"};
  app.require_subcommand(1);
  Options options;
  Outputs outputs;
  std::function<void()> work;
  add_commands(app, options, outputs, work);
  return scan_cell_common::tool_main(
      "ground_truth", app, argc, argv,
      [&] {
        work();
        return 0;
      },
      scan_cell_common::kUnusable, outputs);
}
