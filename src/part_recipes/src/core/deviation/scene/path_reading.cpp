// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "deviation/scene/path_reading.h"

#include <CLI/CLI.hpp>

namespace part_recipes {

PathReading PathReadingOptions::typed() const {
  PathReading typed = reading;
  typed.conventions = conventions.typed(units);
  typed.calls_without_motion = {no_motion.begin(), no_motion.end()};
  return typed;
}

void add_reading_options(CLI::App& app, PathReadingOptions& options) {
  add_path_options(app, options.conventions);
  app.add_option("--program-files", options.reading.program_files,
                 "files that the program calls, if the path is a program");
  app.add_option("--no-motion", options.no_motion, "routines that do not move the robot");
  app.add_option("--dialect", options.reading.dialect, "dialect of the program");
  app.add_flag("--program-in-base", options.reading.program_in_base,
               "the path is in the robot's base frame");
}

}  // namespace part_recipes
