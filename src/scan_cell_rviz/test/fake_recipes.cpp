// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fake_recipes.h"

#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/Marker.h>

#include <utility>

#include "made_preview.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/ros/cloud_messages.h"

namespace scan_cell_rviz {

using scan_cell_msgs::RecipeState;
using scan_cell_msgs::RunRecipeResult;
using scan_cell_msgs::RunSummary;

namespace {

/// A lattice of as many points a side, 1 mm apart.
sensor_msgs::PointCloud2 lattice(int side) {
  scan_cell_common::Cloud cloud;
  for (int i = 0; i < side * side * side; ++i)
    cloud.push_back({static_cast<float>(i % side) * 1e-3F,
                     static_cast<float>(i / side % side) * 1e-3F,
                     static_cast<float>(i / (side * side)) * 1e-3F});
  std_msgs::Header header;
  header.frame_id = "world";
  return scan_cell_common::to_message(cloud, header);
}

/// Five waypoints along x, 10 mm apart, the tool's z axis up, in two segments.
scan_cell_msgs::ToolPath made_path() {
  scan_cell_msgs::ToolPath path;
  path.has_orientation = 1;
  path.process_names = {"speed"};
  path.segments.resize(2);
  path.segments[0].name = "rim";
  path.segments[1].name = "web";
  for (int i = 0; i < 5; ++i) {
    scan_cell_msgs::ToolPathWaypoint waypoint;
    waypoint.pose.position.x = 0.01 * i;
    waypoint.pose.orientation.w = 1;
    waypoint.process_values = {0.05};
    path.segments[i < 3 ? 0 : 1].waypoints.push_back(waypoint);
  }
  return path;
}

}  // namespace

FakeRecipes::FakeRecipes()
    : raw_(node_.advertise<sensor_msgs::PointCloud2>("raw", 1, true)),
      previews_(node_.advertise<scan_cell_msgs::WorkPreview>("/scan_cell/work_preview", 10, true)),
      reference_(node_.advertise<visualization_msgs::Marker>("reference", 1, true)),
      services_({node_.advertiseService("list", &FakeRecipes::list, this),
                 node_.advertiseService("edit", &FakeRecipes::edit, this),
                 node_.advertiseService("runs", &FakeRecipes::runs, this),
                 node_.advertiseService("describe", &FakeRecipes::describe, this),
                 node_.advertiseService("design", &FakeRecipes::design, this),
                 node_.advertiseService("program", &FakeRecipes::program, this),
                 node_.advertiseService("/scan_cell/check_program", &FakeRecipes::check, this),
                 node_.advertiseService("preview", &FakeRecipes::preview, this),
                 node_.advertiseService("approve", &FakeRecipes::approve, this)}),
      server_(
          node_, "run",
          [this](const scan_cell_msgs::RunRecipeGoalConstPtr& goal) { execute(goal); }, false) {
  server_.start();
}

void FakeRecipes::finish(std::uint8_t outcome) {
  const std::lock_guard<std::mutex> lock(mutex_);
  outcome_ = outcome;
}

scan_cell_msgs::RunRecipeGoal FakeRecipes::last_goal() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return goal_;
}

int FakeRecipes::goals() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return goals_;
}

scan_cell_msgs::ApproveRunRequest FakeRecipes::last_decision() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return decision_;
}

scan_cell_msgs::EditRecipeRequest FakeRecipes::last_edit() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return edit_;
}

bool FakeRecipes::edit(scan_cell_msgs::EditRecipe::Request& request,
                       scan_cell_msgs::EditRecipe::Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  edit_ = request;
  response.success = 1;
  return true;
}

/// Plays the cell, too, that shows it.
bool FakeRecipes::preview(scan_cell_msgs::PreviewRun::Request& request,
                          scan_cell_msgs::PreviewRun::Response& response) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    preview_ = request;
  }
  scan_cell_msgs::WorkPreview preview = made_preview();
  preview.dry_run = request.dry_run;
  previews_.publish(preview);
  preview.path = "/runs/of_another_seat/adapted_path.csv";
  preview.waypoints.resize(3);
  previews_.publish(preview);
  response.success = 1;
  return true;
}

scan_cell_msgs::PreviewRunRequest FakeRecipes::last_preview() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return preview_;
}

scan_cell_msgs::DesignPathRequest FakeRecipes::last_design() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return design_;
}

/// On a square of 200 mm about the origin; the path goes from pick to pick, and is refused where
/// one is at y < 0.
bool FakeRecipes::design(scan_cell_msgs::DesignPath::Request& request,
                         scan_cell_msgs::DesignPath::Response& response) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    design_ = request;
  }
  visualization_msgs::Marker square;
  square.header.frame_id = "world";
  square.text = request.recipe;
  square.points.resize(6);
  for (std::size_t i = 0; i < 6; ++i) {
    square.points[i].x = i == 1 || i == 2 || i == 4 ? 0.1 : -0.1;
    square.points[i].y = i == 2 || i == 4 || i == 5 ? 0.1 : -0.1;
  }
  reference_.publish(square);
  scan_cell_msgs::ToolParameter step, closed;
  step.name = "max_step";
  step.unit = "m";
  step.value = "0.01";
  closed.name = "closed";
  closed.value = "false";
  closed.words = {"false", "true"};
  response.parameters = {step};
  if (request.way == scan_cell_msgs::DesignPath::Request::PICKS)
    response.parameters.push_back(closed);
  response.frame = "world";
  response.success = 1;
  if (request.make == 0) return true;
  response.path.segments.resize(1);
  for (const geometry_msgs::Point& pick : request.picks) {
    scan_cell_msgs::ToolPathWaypoint waypoint;
    waypoint.pose.position = pick;
    response.path.segments[0].waypoints.push_back(waypoint);
    if (pick.y >= 0) continue;
    response.success = 0;
    response.message = "pick 1: 3 mm from the surface; pick it on the surface";
  }
  return true;
}

scan_cell_msgs::EditProgramRequest FakeRecipes::last_program() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return program_;
}

/// A line along x and an arc; "old" has none.
bool FakeRecipes::program(scan_cell_msgs::EditProgram::Request& request,
                          scan_cell_msgs::EditProgram::Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (request.set != 0) program_ = request;
  response.success = 1;
  response.frame = "world";
  if (request.recipe != "frame") return true;
  response.passes.resize(2);
  response.passes[0].name = "flank";
  response.passes[0].kind = scan_cell_msgs::ScanPass::LINE;
  response.passes[0].poses.resize(2);
  response.passes[0].poses[1].position.x = 0.3;
  response.passes[1].kind = scan_cell_msgs::ScanPass::ARC;
  response.passes[1].poses.resize(3);
  response.passes[1].poses[0].position.x = 0.1;
  response.passes[1].poses[1].position.y = 0.1;
  response.passes[1].poses[2].position.x = -0.1;
  for (auto& pass : response.passes)
    for (auto& pose : pass.poses)
      pose.orientation.w = 1;
  return true;
}

/// Plays the cell: what is higher than 1 m is out of reach.
bool FakeRecipes::check(scan_cell_msgs::CheckProgram::Request& request,
                        scan_cell_msgs::CheckProgram::Response& response) {
  response.success = 1;
  for (const auto& pass : request.passes)
    for (const auto& pose : pass.poses)
      if (pose.position.z > 1) response.success = 0;
  if (response.success == 0) response.message = "pass 1: the arm is too short";
  return true;
}

bool FakeRecipes::was_cancelled() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return cancelled_;
}

void FakeRecipes::hold_list(std::shared_future<void> until) {
  const std::lock_guard<std::mutex> lock(mutex_);
  list_until_ = std::move(until);
}

void FakeRecipes::give_each_run_a_scan(int side) {
  const std::lock_guard<std::mutex> lock(mutex_);
  side_ = side;
}

void FakeRecipes::execute(const scan_cell_msgs::RunRecipeGoalConstPtr& goal) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    goal_ = *goal;
    outcome_ = -1;
    ++goals_;
  }
  scan_cell_msgs::RunRecipeFeedback feedback;
  feedback.stage = goal->run.empty() ? "scan" : "dry_run";
  server_.publishFeedback(feedback);
  while (ros::ok()) {
    RunRecipeResult result;
    if (server_.isPreemptRequested()) {
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        cancelled_ = true;
      }
      result.message = "stopped by the person";
      server_.setPreempted(result);
      return;
    }
    int outcome = -1;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      outcome = outcome_;
      if (outcome >= 0) state_ = static_cast<std::uint8_t>(outcome);
    }
    if (outcome >= 0) {
      result.outcome = static_cast<std::uint8_t>(outcome);
      result.folder = goal->path_edits.empty() ? "/runs/run_1" : "/runs/run_2";
      result.worked = static_cast<unsigned char>(!goal->run.empty());
      result.work_message = "all waypoints were passed";
      server_.setSucceeded(result);
      return;
    }
    ros::WallDuration(0.01).sleep();
  }
}

bool FakeRecipes::list(scan_cell_msgs::ListRecipes::Request&,
                       scan_cell_msgs::ListRecipes::Response& response) {
  std::shared_future<void> until;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    until = list_until_;
  }
  if (until.valid()) until.wait();
  RecipeState frame, old;
  frame.name = "frame";
  frame.state = RecipeState::PROVEN;
  old.name = "old <b>part</b>";
  old.state = RecipeState::OUT_OF_DATE;
  old.message = "path.csv: changed since the recipe was proven";
  response.recipes = {frame, old};
  return true;
}

RunSummary FakeRecipes::summary() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  RunSummary run;
  run.id = "run_1";
  run.recipe = "frame";
  run.started = "2026-11-25T12:13:14.123Z";
  run.state = state_;
  run.reason = state_ == RunSummary::ACCEPTED ? "accepted" : "wrong_part";
  run.message = state_ == RunSummary::ACCEPTED ? "the path was adapted" : "one region differs";
  run.decision = decided_;
  run.decided_by = decision_.name;
  run.decision_note = decision_.note;
  return run;
}

bool FakeRecipes::runs(scan_cell_msgs::ListRuns::Request&,
                       scan_cell_msgs::ListRuns::Response& response) {
  response.success = 1;
  response.runs = {summary()};
  return true;
}

bool FakeRecipes::describe(scan_cell_msgs::DescribeRun::Request& request,
                           scan_cell_msgs::DescribeRun::Response& response) {
  response.success = 1;
  response.run = summary();
  response.run.id = request.run;
  response.frame = "world";
  if (response.run.state == RunSummary::ACCEPTED) {
    response.path = made_path();
    response.expected_errors = {1e-4, 2e-4, 3e-4, 4e-4, 5e-4};
  }
  response.recipe = "frame";
  response.cleaning =
      "floor: {automatic: false, z_min: 0.0005}\noutliers: {neighbours: 5}\n"
      "edits:\n  - delete: {plane: {point: [0, 0, 0.0085], normal: [0, 0, 1]}}\n";
  int side = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    constexpr int kSide = 10;
    side = side_ > 0 ? side_ : std::exchange(shown_, true) ? 0 : kSide;
  }
  if (side > 0) raw_.publish(lattice(side));
  response.figure_names = {"scale", "rms"};
  response.figure_values = {"1.000012", "0.0213 mm"};
  if (response.run.state != RunSummary::REFUSED) return true;
  response.waypoints_concerned = {3, 17};
  response.waypoint_positions.resize(2);
  response.waypoint_positions[1].x = 0.01;
  response.waypoint_positions[1].y = -0.0205;
  response.waypoint_positions[1].z = 0.003;
  return true;
}

bool FakeRecipes::approve(scan_cell_msgs::ApproveRun::Request& request,
                          scan_cell_msgs::ApproveRun::Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  decision_ = request;
  decided_ = request.approved != 0 ? RunSummary::APPROVED_BY : RunSummary::REFUSED_BY;
  response.success = 1;
  return true;
}

}  // namespace scan_cell_rviz
