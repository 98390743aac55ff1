// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run_server.h"
#include "scan_cell_common/ros/node_main.h"

int main(int argc, char** argv) {
  return scan_cell_common::node_main<part_recipes::RecipeParameters>(
      argc, argv, "part_recipes",
      "Runs parts by their recipes: an action, and a list of the recipes.", [] {
        const part_recipes::RunServer server(ros::NodeHandle("~"));
        ros::spin();
      });
}
