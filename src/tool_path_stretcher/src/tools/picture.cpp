// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>

#include "../picture/verdict_picture.h"
#include "scan_cell_common/errors.h"
#include "scan_cell_common/tool_main.h"
#include "tool_path_stretcher/tool_path_files.h"

namespace {

struct Options {
  std::string reference;
  std::string object;
  std::string path;
  std::string report;
  std::string adapted;
  std::string output;
  std::vector<double> leaf = {0.002, 0.002, 0.0005};
  double azimuth = -60;
  double elevation = 43;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--reference", options.reference, "reference part: PLY, PCD, STL or OBJ [m]")
      ->required();
  app.add_option("--object", options.object, "scanned object: PLY or PCD [m]")->required();
  app.add_option("--path", options.path, "tool path on the reference: CSV or YAML")->required();
  app.add_option("--report", options.report, "what stretch wrote: JSON")->required();
  app.add_option("--adapted", options.adapted, "tool path on the object, where it was accepted");
  app.add_option("--output", options.output, "picture: PNG")->required();
  app.add_option("--leaf", options.leaf, "grid reduction x y z [m]")
      ->capture_default_str()
      ->expected(3);
  app.add_option("--azimuth", options.azimuth, "of the eye about z [deg]")->capture_default_str();
  app.add_option("--elevation", options.elevation, "of the eye over the x-y plane [deg]")
      ->capture_default_str();
}

void run(const Options& options) {
  using namespace tool_path_stretcher;
  constexpr double kDegree = M_PI / 180;
  const Eigen::Vector3d leaf(options.leaf[0], options.leaf[1], options.leaf[2]);
  PictureInput input;
  input.verdict = load_report(options.report);
  input.path = load_tool_path(options.path);
  if (!options.adapted.empty()) input.adapted = load_tool_path(options.adapted);
  input.reference = load_surface(options.reference, leaf);
  input.object = load_surface(options.object, leaf);
  input.azimuth = options.azimuth * kDegree;
  input.elevation = options.elevation * kDegree;
  save_picture(options.output, input);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Shows what stretch made of a path: both clouds, both paths, what differs, and why.");
  Options options;
  add_options(app, options);
  return scan_cell_common::tool_main("picture", app, argc, argv, [&] {
    run(options);
    return 0;
  });
}
