// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/ros.h>
#include <scan_cell_msgs/RunRecipeAction.h>

#include "design_service.h"
#include "recipe_parameters.h"
#include "recipe_services.h"
#include "run/run_recipe.h"

namespace part_recipes {

/// The action ~run, beside the services. One run at a time: the next goal waits for its end.
class RunServer {
 public:
  /// @throw scan_cell_common::InvalidParameter
  explicit RunServer(const ros::NodeHandle& private_node);

 private:
  using Goal = scan_cell_msgs::RunRecipeGoal;
  using Result = scan_cell_msgs::RunRecipeResult;

  void execute(const scan_cell_msgs::RunRecipeGoalConstPtr& goal);
  void tell(const std::string& stage);
  RunRequest request_of(const Goal& goal);
  Result run(const Goal& goal);
  Result work_old(const Goal& goal);
  Result edit_old(const Goal& goal);

  ros::NodeHandle node_;
  RecipeParameters parameters_;
  RecipeServices services_;
  DesignService design_;
  actionlib::SimpleActionServer<scan_cell_msgs::RunRecipeAction> server_;
};

}  // namespace part_recipes
