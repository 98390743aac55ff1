// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "part_options.h"

#include <CLI/CLI.hpp>

#include "scan_cell_common/pose/units.h"

namespace pass_planner {

PartFiles PartOptions::files() const {
  return {reference, path, report, scan_cell_common::metres_per(units),
          path_units.empty() ? units : path_units};
}

SightParameters PartOptions::sight() const {
  SightParameters parameters;
  typed.read(parameters);
  return parameters;
}

void add_part_options(CLI::App& app, PartOptions& options) {
  const CLI::IsMember units(scan_cell_common::length_units());
  app.add_option("--reference", options.reference,
                 "the part in the program's frame: a mesh (STL, OBJ, PLY) or a cloud (PLY, PCD, "
                 "XYZ, CSV)")
      ->required();
  app.add_option("--path", options.path, "tool path on it: CSV or YAML")->required();
  app.add_option("--report", options.report,
                 "report of stretch: part and path are placed where it found them");
  app.add_option("--scanner", options.scanner, "scanner model: YAML")->required();
  app.add_option("--units", options.units, "of part and path")->check(units)->capture_default_str();
  app.add_option("--path-units", options.path_units, "of the path, if different")->check(units);
  options.typed.add(app, SightParameters());
}

}  // namespace pass_planner
