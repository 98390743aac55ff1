// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "stretch_server.h"

#include <chrono>

#include "asked_program.h"
#include "result_markers.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/cloud_messages.h"
#include "scan_cell_common/ros/load_parameters.h"
#include "stretch_messages.h"
#include "tool_path_stretcher/ros/conversions.h"
#include "tool_path_stretcher/seen_from.h"

namespace tool_path_stretcher {
namespace {

void check_frame(const std::string& what, const std_msgs::Header& header,
                 const std_msgs::Header& reference) {
  if (header.frame_id == reference.frame_id) return;
  throw scan_cell_common::UnusableInput(
      what, "in frame '" + header.frame_id + "'",
      "give clouds and path in one frame; the reference is in '" + reference.frame_id + "'");
}

}  // namespace

StretchServer::StretchServer(const ros::NodeHandle& private_node)
    : node_(private_node),
      parameters_(scan_cell_common::load_parameters<StretchParameters>(private_node)),
      reference_(node_.advertise<sensor_msgs::PointCloud2>("reference", 1, true)),
      object_(node_.advertise<sensor_msgs::PointCloud2>("object", 1, true)),
      mapped_reference_(node_.advertise<sensor_msgs::PointCloud2>("mapped_reference", 1, true)),
      reference_path_(node_.advertise<nav_msgs::Path>("reference_path", 1, true)),
      adapted_path_(node_.advertise<nav_msgs::Path>("adapted_path", 1, true)),
      markers_(node_.advertise<visualization_msgs::MarkerArray>("markers", 1, true)),
      server_(
          node_, "stretch", [this](const auto& goal) { execute(goal); }, false) {
  server_.start();
}

void StretchServer::show_input(const scan_cell_msgs::StretchToolPathGoal& goal) {
  reference_.publish(goal.reference);
  object_.publish(goal.object);
}

void StretchServer::show_result(const StretchResult& result, const ToolPath& path,
                                const scan_cell_msgs::StretchToolPathGoal& goal) {
  const std_msgs::Header& header = goal.object.header;
  const ToolPath& reference = result.verdict.accepted() ? result.reference_path : path;
  mapped_reference_.publish(
      scan_cell_common::to_message(to_cloud(result.mapped_reference), header));
  reference_path_.publish(to_path_message(reference, goal.reference.header));
  adapted_path_.publish(to_path_message(result.path, header));
  markers_.publish(result_markers(result, path, header));
}

bool StretchServer::on_progress(const std::string& stage, double progress) {
  scan_cell_msgs::StretchToolPathFeedback feedback;
  feedback.stage = stage;
  feedback.progress = progress;
  server_.publishFeedback(feedback);
  return !server_.isPreemptRequested() && ros::ok();
}

StretchResult StretchServer::run(const scan_cell_msgs::StretchToolPathGoal& goal,
                                 const ToolPath& path, RunRecord& record) {
  const auto start = std::chrono::steady_clock::now();
  const StretchParameters parameters = with_goal(parameters_, goal);
  check_frame("object", goal.object.header, goal.reference.header);
  if (!goal.path.header.frame_id.empty()) {
    check_frame("path", goal.path.header, goal.reference.header);
  }
  on_progress("load", 0);
  const auto surface = [&parameters](const sensor_msgs::PointCloud2& cloud, const char* name) {
    return surface_from_cloud(to_points(scan_cell_common::from_message(cloud)), parameters.leaf,
                              name, directions_seen_from(scan_cell_common::view_of(cloud)));
  };
  const Surface reference = surface(goal.reference, "reference");
  const Surface object = surface(goal.object, "object");
  record.seconds_reading =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return stretch(
      reference, object, path, parameters,
      [this](const std::string& stage, double done) { return on_progress(stage, done); });
}

void StretchServer::execute(const scan_cell_msgs::StretchToolPathGoalConstPtr& goal) {
  show_input(*goal);
  StretchResult result;
  RunRecord record;
  ToolPath path;
  std::optional<AskedProgram> program;
  try {
    program.emplace(*goal);
    path = from_message(goal->path);
    record.path = contents_of(path);
    ROS_INFO("path: %s", to_string(*record.path).c_str());
    result = run(*goal, path, record);
    if (program->wanted() && result.verdict.accepted())
      record.output = program->save(result.path, record.path->units);
  } catch (const scan_cell_common::Error& error) {
    result.verdict = {Reason::kUnusableInput, error.what(), {}};
  }
  show_result(result, path, *goal);
  scan_cell_msgs::StretchToolPathResult message = to_message(result, goal->object.header, record);
  if (result.verdict.accepted() && program->wanted()) program->write(message);
  if (!message.robot_program_error.empty())
    ROS_WARN("no program %s: %s", goal->robot_program.c_str(), message.robot_program_error.c_str());
  const Verdict& verdict = result.verdict;
  if (verdict.accepted()) {
    ROS_INFO("path adapted in %.2f s: %s; scale %.4f, rms %.3f mm", message.seconds,
             to_string(summary_of(result.quality)).c_str(), result.similarity.scale,
             1e3 * result.rms);
    server_.setSucceeded(message, verdict.message);
  } else if (verdict.reason == Reason::kCancelled) {
    server_.setPreempted(message, verdict.message);
  } else {
    ROS_WARN("path refused (%s): %s", to_string(verdict.reason).c_str(), verdict.message.c_str());
    server_.setAborted(message, verdict.message);
  }
}

}  // namespace tool_path_stretcher
