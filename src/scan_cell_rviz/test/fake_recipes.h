// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/ros.h>
#include <scan_cell_msgs/ApproveRun.h>
#include <scan_cell_msgs/CheckProgram.h>
#include <scan_cell_msgs/DescribeRun.h>
#include <scan_cell_msgs/DesignPath.h>
#include <scan_cell_msgs/EditProgram.h>
#include <scan_cell_msgs/EditRecipe.h>
#include <scan_cell_msgs/ListRecipes.h>
#include <scan_cell_msgs/ListRuns.h>
#include <scan_cell_msgs/PreviewRun.h>
#include <scan_cell_msgs/RunRecipeAction.h>

#include <future>
#include <memory>
#include <mutex>

namespace scan_cell_rviz {

/// Plays part_recipes_node: recipes "frame" (proven) and "old" (out of date), runs that end when
/// the test says so.
class FakeRecipes {
 public:
  FakeRecipes();

  /// The goal under way ends as an accepted run, a refused one, or a work that was done.
  void finish(std::uint8_t outcome);

  scan_cell_msgs::RunRecipeGoal last_goal() const;
  int goals() const;
  scan_cell_msgs::ApproveRunRequest last_decision() const;
  scan_cell_msgs::EditRecipeRequest last_edit() const;
  scan_cell_msgs::PreviewRunRequest last_preview() const;
  scan_cell_msgs::DesignPathRequest last_design() const;
  scan_cell_msgs::EditProgramRequest last_program() const;  ///< that was saved
  bool was_cancelled() const;

  /// From now on each run that is described has a scan of its own, a cube of `side` points a side.
  void give_each_run_a_scan(int side);

  /// From now on ~list answers when the promise is kept.
  void hold_list(std::shared_future<void> until);

 private:
  void execute(const scan_cell_msgs::RunRecipeGoalConstPtr& goal);
  bool list(scan_cell_msgs::ListRecipes::Request&, scan_cell_msgs::ListRecipes::Response&);
  bool runs(scan_cell_msgs::ListRuns::Request&, scan_cell_msgs::ListRuns::Response&);
  bool describe(scan_cell_msgs::DescribeRun::Request&, scan_cell_msgs::DescribeRun::Response&);
  bool approve(scan_cell_msgs::ApproveRun::Request&, scan_cell_msgs::ApproveRun::Response&);
  bool edit(scan_cell_msgs::EditRecipe::Request&, scan_cell_msgs::EditRecipe::Response&);
  bool preview(scan_cell_msgs::PreviewRun::Request&, scan_cell_msgs::PreviewRun::Response&);
  bool design(scan_cell_msgs::DesignPath::Request&, scan_cell_msgs::DesignPath::Response&);
  bool program(scan_cell_msgs::EditProgram::Request&, scan_cell_msgs::EditProgram::Response&);
  bool check(scan_cell_msgs::CheckProgram::Request&, scan_cell_msgs::CheckProgram::Response&);
  scan_cell_msgs::RunSummary summary() const;

  mutable std::mutex mutex_;
  scan_cell_msgs::RunRecipeGoal goal_;
  scan_cell_msgs::ApproveRunRequest decision_;
  scan_cell_msgs::EditRecipeRequest edit_;
  scan_cell_msgs::PreviewRunRequest preview_;
  scan_cell_msgs::DesignPathRequest design_;
  scan_cell_msgs::EditProgramRequest program_;
  int goals_ = 0;
  int outcome_ = -1;
  std::uint8_t state_ = scan_cell_msgs::RunSummary::ACCEPTED;
  std::uint8_t decided_ = scan_cell_msgs::RunSummary::OPEN;
  bool cancelled_ = false;
  bool shown_ = false;  // the run
  int side_ = 0;        // of a scan of each run; 0: one scan for all
  std::shared_future<void> list_until_;

  ros::NodeHandle node_{"/part_recipes"};
  ros::Publisher raw_;
  ros::Publisher previews_;
  ros::Publisher reference_;
  std::vector<ros::ServiceServer> services_;
  actionlib::SimpleActionServer<scan_cell_msgs::RunRecipeAction> server_;
};

}  // namespace scan_cell_rviz
