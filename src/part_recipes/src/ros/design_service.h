// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <scan_cell_msgs/DesignPath.h>

#include <string>

#include "recipe/recipe.h"
#include "recipe_parameters.h"
#include "tool_paths/tool_path.h"

namespace part_recipes {

/// Paths on the references of recipes: ~design makes one, and a recipe with it if asked to. They
/// are shown in rviz on latched topics: ~reference (its triangles, and the recipe's name as text),
/// ~designed_path, and ~picks. The service waits for a tool; as a cancel of a run must not wait for
/// it, it has a thread of its own.
class DesignService {
 public:
  DesignService(ros::NodeHandle node, const RecipeParameters& parameters);

 private:
  using Request = scan_cell_msgs::DesignPath::Request;
  using Response = scan_cell_msgs::DesignPath::Response;

  bool design(Request& request, Response& response);
  void make(const Recipe& recipe, const Request& request, Response& response);
  void show_reference(const Recipe& recipe, const Request& request);
  void show(const tool_paths::ToolPath& path, const tool_paths::Points& picks,
            const std_msgs::Header& header);

  RecipeParameters parameters_;
  std::string shown_;  // identifies the reference in view; empty: none
  ros::Publisher reference_, path_, picks_;
  ros::CallbackQueue queue_;
  ros::ServiceServer service_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace part_recipes
