// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>

#include "part_options.h"
#include "pass_planner/part.h"
#include "pass_planner/sight.h"
#include "pass_planner/sight_report.h"
#include "scan_cell/scan_program.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

struct Options {
  pass_planner::PartOptions part;
  std::string program;
  std::string output;
};

/// @return the process's exit code
int look(const Options& options) {
  using namespace pass_planner;
  const auto scanner = scan_cell_common::load_scanner_model(options.part.scanner);
  const scan_cell::ScanProgram program = scan_cell::load_scan_program(options.program);
  check({"", program.passes}, scan_cell::ScanLimits());
  const PlacedPart part = load_part(options.part.files());
  const Surface surface(part.shape);
  const std::vector<Surface::Place> places = places_of(part.waypoints, surface);
  const SightCheck check(scanner, surface, options.part.sight());
  const PathSight sight = look_along(check, sweeps_of(program.passes), places);
  scan_cell_common::save_text(options.output, sight_to_json(places, sight, program.passes));
  std::printf("%s\n", summary_of(sight).c_str());
  return sight.not_seen().empty() ? 0 : scan_cell_common::kRefused;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Tells which waypoints of a path a scan program sees, and what hinders the others.\n"
      "Exit code 0: all are seen; 2: some are not, the output says why; 1: unusable input.");
  Options options;
  scan_cell_common::Outputs outputs;
  add_part_options(app, options.part);
  app.add_option("--program", options.program, "scan program: YAML")->required();
  outputs.add(app, "--output", options.output, "what was seen: JSON")->required();
  return scan_cell_common::tool_main(
      "seen_waypoints", app, argc, argv,
      [&] {
        scan_cell_common::check_output(options.output, {".json"}, "write what was seen as .json");
        return look(options);
      },
      scan_cell_common::kUnusable, outputs);
}
