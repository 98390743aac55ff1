// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace scan_cell_common {

/// The main() of a node: initialises ROS, runs `body` (which makes the node and spins), and turns
/// an error into one fatal line and exit code 1.
int node_main(int argc, char** argv, const std::string& name, const std::function<void()>& body);

}  // namespace scan_cell_common
