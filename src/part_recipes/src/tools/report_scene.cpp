// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>

#include "deviation/adapted_part.h"
#include "deviation/deviation_files.h"
#include "deviation/scene/path_reading.h"
#include "deviation/scene/path_scene.h"
#include "deviation/scene/reference_scene.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tool_path_stretcher/surface.h"

namespace {

using scan_cell_common::Outputs;

struct SurfaceOptions {
  part_recipes::AdaptedFiles files;
  double tolerance = 0.0005;
  std::string output;
};

struct PathsOptions {
  std::string path, adapted, report;
  part_recipes::PathReadingOptions reading;
  std::string output;
};

CLI::App* add_surface(CLI::App& app, SurfaceOptions& options, Outputs& outputs) {
  CLI::App* command = app.add_subcommand("surface", "the reference as it lies on the object");
  command->add_option("--reference", options.files.reference, "cloud or mesh")->required();
  command->add_option("--reference-units", options.files.reference_units, "m, mm or inch")
      ->check(CLI::IsMember(scan_cell_common::length_units()));
  command->add_option("--object", options.files.object, "scanned object in metres");
  command->add_option("--report", options.files.report,
                      "report that stretch wrote; without it the reference stays where it is");
  command->add_option("--tolerance", options.tolerance, "tolerance of deviations [m]")
      ->check(CLI::PositiveNumber);
  outputs
      .add(*command, "--output", options.output,
           "points of the reference with the fields scanned and rim: PLY")
      ->required();
  return command;
}

CLI::App* add_paths(CLI::App& app, PathsOptions& options, Outputs& outputs) {
  CLI::App* command = app.add_subcommand("paths", "the path on the reference and the adapted one");
  command->add_option("--path", options.path, "tool path on the reference: CSV, YAML or a program")
      ->required();
  command->add_option("--path-units", options.reading.units, "m, mm or inch");
  add_reading_options(*command, options.reading);
  command->add_option("--adapted", options.adapted,
                      "tool path on the object, in the format of the other");
  command->add_option("--report", options.report,
                      "report that stretch wrote; without it the path stays where it is");
  outputs.add(*command, "--output", options.output, "waypoints in metres: JSON")->required();
  return command;
}

void write_surface(const SurfaceOptions& options) {
  using namespace part_recipes;
  scan_cell_common::check_cloud_output(options.output);
  AdaptedPart part;
  if (!options.files.report.empty())
    part = load_adapted_part(options.files);
  else if (!options.files.reference_units.empty())
    part.metres_per_unit = scan_cell_common::metres_per(options.files.reference_units);
  Points object;
  if (part.similarity) {
    object = tool_path_stretcher::to_points(scan_cell_common::load_cloud(options.files.object));
  }
  const ReferenceScene scene = load_reference_scene(options.files.reference, part.metres_per_unit,
                                                    part.similarity, object, options.tolerance);
  save_fields(options.output, scene.points, {"scanned", "rim"}, {scene.scanned, scene.rim});
}

void write_paths(const PathsOptions& options) {
  using namespace part_recipes;
  scan_cell_common::check_output(options.output, {".json"}, "write the waypoints as .json");
  AdaptedPart part;
  if (!options.report.empty()) part = load_adapted_part({"", "", "", options.report});
  const PathReading reading = options.reading.typed();
  PathPair paths{load_path(options.path, reading), std::nullopt};
  if (!options.adapted.empty()) paths.adapted = load_path(options.adapted, reading);
  scan_cell_common::save_text(options.output, to_json(paths, part.similarity));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("What the page of a run draws of the reference and the tool paths.");
  app.require_subcommand(1);
  SurfaceOptions surface;
  PathsOptions paths;
  Outputs outputs;
  const CLI::App* surface_command = add_surface(app, surface, outputs);
  add_paths(app, paths, outputs);
  return scan_cell_common::tool_main(
      "report_scene", app, argc, argv,
      [&] {
        if (surface_command->parsed())
          write_surface(surface);
        else
          write_paths(paths);
        return 0;
      },
      scan_cell_common::kUnusable, outputs);
}
