// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "part_options.h"
#include "pass_planner/plan.h"
#include "scan_cell/scan_program.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

using namespace pass_planner;
using scan_cell_common::Refused;

struct Options {
  PartOptions part;
  std::string program;
  std::string frame = "world";
  std::string output;
  std::string urdf;
  std::string cell;
  std::vector<double> start;
  scan_cell_common::ParameterOptions plan;
  scan_cell_common::ParameterOptions limits;
};

RobotInCell robot_of(const Options& options, const std::string& frame) {
  RobotInCell robot;
  robot.frame = frame;
  robot.urdf = scan_cell_common::read_file(options.urdf);
  robot.base_link_in_world =
      scan_cell_common::YamlEntry::load(options.cell)["base_link_in_world"].pose();
  options.limits.read(robot.limits);
  if (!options.start.empty()) robot.start = c4g_driver::Joints(options.start.data());
  return robot;
}

/// "waypoints 3, 4, 5: why; waypoints 9: why"
std::string reasons_of(const PassPlan& plan, const std::vector<std::size_t>& wanted) {
  std::map<std::string, std::vector<std::size_t>> waypoints;
  for (std::size_t i = 0; i < plan.left.size(); ++i)
    waypoints[plan.why[i]].push_back(wanted[plan.left[i]]);
  std::vector<std::string> texts;
  for (const auto& [why, which] : waypoints)
    texts.push_back(fmt::format("waypoints {}: {}", fmt::join(which, ", "), why));
  return fmt::format("{}", fmt::join(texts, "; "));
}

/// Waypoints that the program before does not see; with a report, those that it names.
std::vector<std::size_t> wanted_of(const Options& options, const PlacedPart& part,
                                   const SightCheck& check, const Surface& surface,
                                   const scan_cell::ScanProgram& before) {
  if (before.passes.empty() || !options.part.report.empty()) return part.wanted;
  return look_along(check, sweeps_of(before.passes), places_of(part.waypoints, surface)).not_seen();
}

void plan_and_save(const Options& options) {
  PlanParameters parameters;
  if (!options.part.report.empty()) parameters.max_passes = 1;
  options.plan.read(parameters);
  const auto scanner = scan_cell_common::load_scanner_model(options.part.scanner);
  check_can_scan(scanner);
  scan_cell::ScanProgram program = {options.frame, {}};
  if (!options.program.empty()) {
    program = scan_cell::load_scan_program(options.program);
    check({"", program.passes}, scan_cell::ScanLimits());
  }
  const PlacedPart part = load_part(options.part.files());
  const Surface surface(part.shape);
  const SightParameters sight = options.part.sight();
  const auto wanted =
      wanted_of(options, part, SightCheck(scanner, surface, sight), surface, program);
  const PassPlan plan =
      plan_passes(scanner, surface, places_of(part.waypoints, surface, wanted), sight,
                  Reach(robot_of(options, program.frame)), parameters, program.passes);
  if (!plan.left.empty()) {
    throw Refused(fmt::format("{} of {} waypoints", plan.left.size(), wanted.size()),
                  fmt::format("not seen by {} {}", plan.passes.size(),
                              plan.passes.size() == 1 ? "pass" : "passes"),
                  reasons_of(plan, wanted));
  }
  for (const scan_cell::ScanPass& pass : plan.passes) {
    const std::string lasers = pass.lasers == scan_cell::PassLasers::kAlternate
                                   ? "both lasers in turns"
                                   : fmt::format("laser {}", static_cast<int>(pass.lasers));
    std::printf("%s, %s\n", pass.name.c_str(), lasers.c_str());
    program.passes.push_back(pass);
  }
  check({"", program.passes}, scan_cell::ScanLimits());
  save_scan_program(options.output, program);
  std::printf("%s: %zu passes, %zu of them new, for %zu waypoints\n", options.output.c_str(),
              program.passes.size(), plan.passes.size(), wanted.size());
}

void add_options(CLI::App& app, Options& options, scan_cell_common::Outputs& outputs) {
  add_part_options(app, options.part);
  app.add_option("--program", options.program,
                 "scan program (YAML) to extend by passes for what it does not see");
  app.add_option("--frame", options.frame,
                 "of part and new program, without --program: world or base_link")
      ->capture_default_str();
  outputs.add(app, "--output", options.output, "scan program: YAML")->required();
  app.add_option("--urdf", options.urdf, "of the robot, as for c4g_driver")->required();
  app.add_option("--cell", options.cell, "pose of the robot: cell.yaml")->required();
  app.add_option("--start-joints", options.start,
                 "[rad] six, where the robot stands before the program")
      ->expected(6);
  options.plan.add(app, PlanParameters());
  options.limits.add(app, c4g_driver::RobotLimits());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Proposes a scan program that sees each waypoint of a path, within the robot's reach.\n"
      "With --report of a refused stretch: the one pass that sees what was not scanned.\n"
      "Exit code 0: there is one; 2: some waypoints cannot be seen, and why; 1: unusable input.");
  Options options;
  scan_cell_common::Outputs outputs;
  add_options(app, options, outputs);
  return scan_cell_common::tool_main(
      "plan_passes", app, argc, argv,
      [&] {
        scan_cell_common::check_output(options.output, {".yaml"}, "write the program as .yaml");
        plan_and_save(options);
        return 0;
      },
      scan_cell_common::kRefused, outputs);
}
