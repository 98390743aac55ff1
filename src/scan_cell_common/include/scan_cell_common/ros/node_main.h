// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "scan_cell_common/parameters/parameter_table.h"
#include "scan_cell_common/tools/tool_main.h"

namespace scan_cell_common {

/// The main() of a node: answers --help and --version without ROS, initialises ROS, runs `body`
/// (which makes the node and spins), and turns an error into one fatal line and exit code 1. Any
/// other word on its command line that is not for ROS (NAME:=VALUE) is refused. SIGTERM and SIGHUP
/// end the node as Ctrl-C does: ROS shuts down, `body` returns, and its objects are destroyed.
/// @param description one sentence for --help
/// @param before_threads runs while the process has only one thread, for example to fork
/// @param parameters text that --parameters prints; empty: no such option
int node_main(int argc, char** argv, const std::string& name, const std::string& description,
              const std::function<void()>& body, const std::function<void()>& before_threads = {},
              const std::string& parameters = "");

/// The same for a node that has `Parameters`, which --parameters lists.
template <class Parameters>
int node_main(int argc, char** argv, const std::string& name, const std::string& description,
              const std::function<void()>& body, const std::function<void()>& before_threads = {}) {
  return node_main(argc, argv, name, description, body, before_threads,
                   parameter_rows<Parameters>());
}

/// tool_main() for a tool that is a client of a running cell: removes the words for ROS
/// (NAME:=VALUE) from the command line, and runs `body` under an anonymous node name with two
/// threads for callbacks. If no ROS master answers within 10 s, it ends and says so.
int ros_tool_main(const std::string& name, CLI::App& options, int argc, char** argv,
                  const std::function<int()>& body, int refused = kUnusable,
                  const Outputs& outputs = {});

}  // namespace scan_cell_common
