// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pass_planner/part.h"
#include "pass_planner/sight.h"
#include "scan_cell_common/parameters/parameter_options.h"

namespace pass_planner {

/// Options of both tools: the part, its path, the scanner and what it can measure.
struct PartOptions {
  std::string reference;
  std::string path;
  std::string report;
  std::string scanner;
  std::string units = "m";
  std::string path_units;
  scan_cell_common::ParameterOptions typed;

  PartFiles files() const;
  SightParameters sight() const;
};

void add_part_options(CLI::App& app, PartOptions& options);

}  // namespace pass_planner
