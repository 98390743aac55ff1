// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "file_options.h"

#include <CLI/CLI.hpp>

namespace tool_path_stretcher {
namespace {

std::string first_given(const std::string& own, const std::string& of_all) {
  if (!own.empty()) return own;
  return of_all.empty() ? "m" : of_all;
}

}  // namespace

std::string FileOptions::units_of_reference() const {
  return first_given(reference_units, units);
}

std::string FileOptions::units_of_object() const {
  return first_given(object_units, units);
}

tool_paths::PathConventions FileOptions::path_conventions() const {
  return path.typed(path_units.empty() ? units : path_units);
}

void add_file_options(CLI::App& app, FileOptions& options) {
  app.add_option("--units", options.units,
                 "lengths in the files: m, mm or inch; all other options and the report are in m");
  app.add_option("--reference-units", options.reference_units,
                 "unit of the reference, if different");
  app.add_option("--object-units", options.object_units, "unit of the object, if different");
  app.add_option("--path-units", options.path_units, "unit of the tool paths, if different");
  add_path_options(app, options.path);
}

}  // namespace tool_path_stretcher
