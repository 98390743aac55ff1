// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <scan_cell_msgs/CheckProgram.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "scan_cell/ros/scan_goal.h"
#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/ros/node_main.h"

namespace {

/// @throw Refused if the cell could not scan the program, naming the pass
/// @throw ConnectionError if that cannot be found out
void check(const std::string& file, const std::string& cell, double timeout) {
  const scan_cell::ScanProgram program = scan_cell::load_scan_program(file);
  const scan_cell_msgs::ScanGoal goal = scan_cell::scan_goal(program, "");
  scan_cell_msgs::CheckProgram::Request request;
  request.frame = goal.frame;
  request.passes = goal.passes;
  const std::string service = cell + "/check_program";
  const auto answer = scan_cell::ask<scan_cell_msgs::CheckProgram>(service, request, timeout);
  if (answer.link_lost != 0)
    throw scan_cell_common::ConnectionError(file, "not checked", answer.message);
  scan_cell::check_answer(service, answer);
  for (const std::string& warning : answer.warnings)
    std::printf("%s: warning: %s\n", file.c_str(), warning.c_str());
  std::printf("%s: %zu %s, nothing stands in the way from where the robot stands now\n",
              file.c_str(), program.passes.size(), program.passes.size() == 1 ? "pass" : "passes");
}

}  // namespace

int main(int argc, char** argv) {
  std::string program;
  std::string cell = "/scan_cell";
  double timeout = 20;
  CLI::App app("Checks whether the running cell could scan a program; nothing moves");
  app.add_option("--program", program, "scan program (YAML)")->required();
  app.add_option("--cell", cell, "node that directs the cell")->capture_default_str();
  app.add_option("--timeout", timeout, "seconds to wait for the answer")->capture_default_str();
  return scan_cell_common::ros_tool_main(
      "check_program", app, argc, argv,
      [&] {
        check(program, cell, timeout);
        return 0;
      },
      scan_cell_common::kRefused);
}
