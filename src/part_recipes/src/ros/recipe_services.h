// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <scan_cell_msgs/ApproveRun.h>
#include <scan_cell_msgs/DescribeRun.h>
#include <scan_cell_msgs/EditProgram.h>
#include <scan_cell_msgs/EditRecipe.h>
#include <scan_cell_msgs/ListRecipes.h>
#include <scan_cell_msgs/ListRuns.h>
#include <scan_cell_msgs/PreviewRun.h>

#include <filesystem>
#include <string>

#include "recipe_parameters.h"
#include "run_display.h"

namespace part_recipes {

/// Services about recipes and runs: ~list, ~edit, ~program, ~runs, ~describe (which also shows the
/// run in rviz), ~preview of its work, and ~approve.
class RecipeServices {
 public:
  RecipeServices(ros::NodeHandle node, const RecipeParameters& parameters);

 private:
  bool list(scan_cell_msgs::ListRecipes::Request& request,
            scan_cell_msgs::ListRecipes::Response& response);
  bool edit(scan_cell_msgs::EditRecipe::Request& request,
            scan_cell_msgs::EditRecipe::Response& response);
  bool program(scan_cell_msgs::EditProgram::Request& request,
               scan_cell_msgs::EditProgram::Response& response);
  bool runs(scan_cell_msgs::ListRuns::Request& request,
            scan_cell_msgs::ListRuns::Response& response);
  bool describe(scan_cell_msgs::DescribeRun::Request& request,
                scan_cell_msgs::DescribeRun::Response& response);
  bool preview(scan_cell_msgs::PreviewRun::Request& request,
               scan_cell_msgs::PreviewRun::Response& response);
  bool approve(scan_cell_msgs::ApproveRun::Request& request,
               scan_cell_msgs::ApproveRun::Response& response);

  /// @throw scan_cell_common::InvalidParameter if the id would lead elsewhere
  std::filesystem::path folder_of(const std::string& run) const;

  RecipeParameters parameters_;
  RunDisplay display_;
  ros::ServiceServer list_, edit_, program_, runs_, describe_, approve_;

  // It waits for the cell; a cancel of a run must not wait for it.
  ros::CallbackQueue preview_queue_;
  ros::ServiceServer preview_;
  ros::AsyncSpinner preview_spinner_{1, &preview_queue_};
};

}  // namespace part_recipes
