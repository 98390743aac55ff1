// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_paths/path_options.h"

#include <CLI/CLI.hpp>

namespace tool_paths {

PathConventions PathOptions::typed(const std::string& units) const {
  PathConventions result = conventions;
  result.units = units;
  if (degrees) result.angles = AngleUnit::kDegrees;
  if (radians) result.angles = AngleUnit::kRadians;
  return result;
}

void add_path_options(CLI::App& app, PathOptions& options) {
  PathConventions& path = options.conventions;
  app.add_option("--euler", path.euler,
                 "Euler angles in the path: axes in the order of the rotations, each about the "
                 "rotated frame (zyx: Kuka, Fanuc, roll-pitch-yaw; zyz: Comau)");
  app.add_flag("--rotation-vector", path.rotation_vector,
               "angles in the path are a rotation vector (Universal Robots)");
  CLI::Option* const degrees =
      app.add_flag("--degrees", options.degrees, "angles in the path are in degrees");
  app.add_flag("--radians", options.radians, "angles in the path are in radians")
      ->excludes(degrees);
  app.add_option(
         "--process-values", path.process_values,
         "names in the path, separated by commas, that look like an orientation but are not one")
      ->delimiter(',');
}

}  // namespace tool_paths
