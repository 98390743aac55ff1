// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>

#include "path_design/designed_path.h"
#include "path_design/picks_file.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tool_paths/tool_path_files.h"

namespace {

using namespace part_recipes;
using scan_cell_common::Outputs;
using scan_cell_common::ParameterOptions;

struct Options {
  std::string reference;
  std::string units = "m";
  std::string picks;
  std::string output;
  ParameterOptions typed;
};

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& meaning,
                      Options& options, Outputs& outputs) {
  CLI::App* const command = app.add_subcommand(name, meaning);
  command
      ->add_option("--reference", options.reference,
                   "reference part: a mesh (STL, OBJ, PLY) or a cloud (PLY, PCD, XYZ, CSV)")
      ->required();
  command->add_option("--reference-units", options.units, "units of the reference: m, mm or inch")
      ->capture_default_str();
  outputs.add(*command, "--output", options.output, "tool path on the reference: CSV or YAML [m]")
      ->required();
  return command;
}

void save(const Options& options, const DesignedPath& designed) {
  tool_paths::save_tool_path(options.output, designed.path);
  double length = 0;
  for (const tool_paths::Segment& segment : designed.path.segments)
    for (std::size_t i = 1; i < segment.waypoints.size(); ++i)
      length +=
          (segment.waypoints[i].pose.translation() - segment.waypoints[i - 1].pose.translation())
              .norm();
  for (const std::string& note : designed.notes)
    std::cout << note << '\n';
  std::cout << fmt::format("{}: {} waypoints in {} segment{}, {:.3f} m long\n", options.output,
                           tool_paths::waypoint_count(designed.path), designed.path.segments.size(),
                           designed.path.segments.size() == 1 ? "" : "s", length);
}

/// Reads the parameters and the reference, makes the path and saves it.
template <class Parameters>
void run(const Options& options,
         const std::function<DesignedPath(const path_design::PartMesh&, const Parameters&)>& make) {
  tool_paths::check_tool_path_name(options.output);
  Parameters parameters;
  options.typed.read(parameters);
  const double metres = scan_cell_common::metres_per(options.units);
  const auto reference = load_reference_surface(options.reference, metres, parameters.path);
  save(options, make(reference, parameters));
}

DesignedPath through_picks(const Options& options, const path_design::PartMesh& reference,
                           const PickParameters& parameters) {
  const double metres = scan_cell_common::metres_per(options.units);
  return path_from_picks(reference, load_picks(options.picks, metres), parameters);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Makes a tool path from a reference part that has none. Lengths are in metres, angles in "
      "radians.\nExit code 0: the path was written; 2: refused; 1: unusable input.");
  app.require_subcommand(1);
  Outputs outputs;
  Options edge, slices, picks;
  CLI::App* const from_edge = add_command(
      app, "from-edge", "Along the edges of the part, or of one face of it", edge, outputs);
  edge.typed.add(*from_edge, EdgeParameters());
  CLI::App* const from_slices =
      add_command(app, "from-slices", "A raster over the visible side", slices, outputs);
  slices.typed.add(*from_slices, SliceParameters());
  CLI::App* const from_picks =
      add_command(app, "from-picks", "A smooth line through picked points", picks, outputs);
  from_picks
      ->add_option("--picks", picks.picks,
                   "points on the surface: CSV of x, y and z in the reference's unit")
      ->required();
  picks.typed.add(*from_picks, PickParameters());
  return scan_cell_common::tool_main(
      "path", app, argc, argv,
      [&] {
        if (from_edge->parsed()) run<EdgeParameters>(edge, path_from_edge);
        if (from_slices->parsed()) run<SliceParameters>(slices, path_from_slices);
        if (from_picks->parsed())
          run<PickParameters>(picks, [&picks](const auto& reference, const auto& parameters) {
            return through_picks(picks, reference, parameters);
          });
        return 0;
      },
      scan_cell_common::kRefused, outputs);
}
