// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/ros.h>
#include <scan_cell_msgs/ListRecipes.h>
#include <scan_cell_msgs/RunRecipeAction.h>

#include "recipe_parameters.h"
#include "run/run_recipe.h"

namespace part_recipes {

/// The action ~run and the service ~list. One run at a time: the next goal waits for its end.
class RunServer {
 public:
  /// @throw scan_cell_common::InvalidParameter
  explicit RunServer(const ros::NodeHandle& private_node);

 private:
  using Goal = scan_cell_msgs::RunRecipeGoal;
  using Result = scan_cell_msgs::RunRecipeResult;

  void execute(const scan_cell_msgs::RunRecipeGoalConstPtr& goal);
  RunRequest request_of(const Goal& goal);
  Result run(const Goal& goal);
  bool list(scan_cell_msgs::ListRecipes::Request&, scan_cell_msgs::ListRecipes::Response& response);

  ros::NodeHandle node_;
  RecipeParameters parameters_;
  ros::ServiceServer list_;
  actionlib::SimpleActionServer<scan_cell_msgs::RunRecipeAction> server_;
};

}  // namespace part_recipes
