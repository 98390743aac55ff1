// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>

#include "../picture/verdict_picture.h"
#include "file_options.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tool_paths/tool_path_files.h"

namespace {

struct Options {
  std::string reference;
  std::string object;
  std::string path;
  std::string report;
  std::string adapted;
  std::string output;
  tool_path_stretcher::FileOptions files;
  std::vector<double> leaf = {0.002, 0.002, 0.0005};
  bool overlay = false;
  double azimuth = -60;
  double elevation = 43;
};

void add_options(CLI::App& app, Options& options, scan_cell_common::Outputs& outputs) {
  app.add_option("--reference", options.reference,
                 "reference part: a cloud (PLY, PCD, XYZ, CSV) or a mesh (STL, OBJ, PLY)")
      ->required();
  app.add_option("--object", options.object, "scanned object: PLY, PCD, XYZ or CSV")->required();
  app.add_option("--path", options.path, "tool path on the reference: CSV or YAML")->required();
  app.add_option("--report", options.report, "report of stretch: JSON")->required();
  app.add_option("--adapted", options.adapted, "tool path on the object, if it was accepted");
  outputs.add(app, "--output", options.output, "picture: PNG")->required();
  add_file_options(app, options.files);
  app.add_option("--leaf", options.leaf, "grid reduction x y z [m]")
      ->capture_default_str()
      ->expected(3);
  app.add_flag("--overlay", options.overlay,
               "draw the reference over the object, where the similarity puts it, not beside it");
  app.add_option("--azimuth", options.azimuth, "of the viewpoint about z [deg]")
      ->capture_default_str();
  app.add_option("--elevation", options.elevation, "of the viewpoint above the x-y plane [deg]")
      ->capture_default_str();
}

/// Units that are not given default to those of the run.
tool_path_stretcher::FileOptions with_reported_units(
    tool_path_stretcher::FileOptions options, const tool_path_stretcher::ReportedVerdict& verdict) {
  if (!options.units.empty()) return options;
  if (options.reference_units.empty() && verdict.reference)
    options.reference_units = verdict.reference->units;
  if (options.object_units.empty() && verdict.object) options.object_units = verdict.object->units;
  if (options.path_units.empty() && verdict.path) options.path_units = verdict.path->units;
  return options;
}

void run(const Options& options) {
  using namespace tool_path_stretcher;
  using scan_cell_common::kDegree;
  scan_cell_common::check_output(options.output, {".png"}, "write the picture as .png");
  const Eigen::Vector3d leaf(options.leaf[0], options.leaf[1], options.leaf[2]);
  PictureInput input;
  input.verdict = load_report(options.report);
  check_same_files(input.verdict,
                   {options.reference, options.object, options.path, options.adapted});
  const FileOptions files = with_reported_units(options.files, input.verdict);
  input.path = tool_paths::load_tool_path(options.path, files.path_conventions());
  if (!options.adapted.empty())
    input.adapted = tool_paths::load_tool_path(options.adapted, files.path_conventions());
  input.reference = load_surface(options.reference, leaf,
                                 scan_cell_common::metres_per(files.units_of_reference()));
  input.object =
      load_surface(options.object, leaf, scan_cell_common::metres_per(files.units_of_object()));
  check_figures(input);
  input.overlay = options.overlay;
  input.azimuth = options.azimuth * kDegree;
  input.elevation = options.elevation * kDegree;
  save_picture(options.output, input);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Shows what stretch made of a path: both clouds, both paths, what differs, and why.");
  Options options;
  scan_cell_common::Outputs outputs;
  add_options(app, options, outputs);
  return scan_cell_common::tool_main(
      "picture", app, argc, argv,
      [&] {
        run(options);
        return 0;
      },
      scan_cell_common::kUnusable, outputs);
}
