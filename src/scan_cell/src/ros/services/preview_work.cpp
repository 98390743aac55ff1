// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "services/preview_work.h"

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/service_answer.h"

namespace scan_cell {
namespace {

constexpr std::int32_t kNone = -1;  // WorkPreview.msg

void add_waypoints(scan_cell_msgs::WorkPreview& preview, const WorkPlan& plan) {
  for (const WorkWaypoint& waypoint : plan.waypoints) {
    preview.waypoints.push_back(message_of(waypoint));
    preview.path_waypoints.push_back(
        waypoint.waypoint ? static_cast<std::int32_t>(*waypoint.waypoint) : kNone);
  }
}

void add_check(scan_cell_msgs::WorkPreview& preview,
               const scan_cell_msgs::CheckFollow::Response& check) {
  preview.joint_names = check.joint_names;
  preview.joints = check.joints;
  preview.faults = check.faults;
  preview.message = check.message;
  preview.slowest_speed = check.slowest_speed;
  preview.slowest_waypoint = check.slowest_waypoint;
}

}  // namespace

PreviewWork::PreviewWork(ros::NodeHandle node, const std::string& base_frame,
                         const WorkPlanner& planner, const RosRobot& robot)
    : base_frame_(base_frame),
      planner_(planner),
      robot_(robot),
      shown_(node.advertise<scan_cell_msgs::WorkPreview>("work_preview", 1, true)),
      server_(node.advertiseService("preview_work", &PreviewWork::serve, this)) {}

bool PreviewWork::serve(scan_cell_msgs::PreviewWork::Request& request,
                        scan_cell_msgs::PreviewWork::Response& response) {
  return scan_cell_common::answer(response, [&] {
    const auto report = tool_path_programs::accepted_report(request.goal.report, request.goal.path);
    const WorkPlan plan = planner_.plan(request.goal, report);
    scan_cell_msgs::WorkPreview& preview = response.preview;
    preview.header.frame_id = base_frame_;
    preview.header.stamp = ros::Time::now();
    preview.path = request.goal.path;
    preview.dry_run = request.goal.dry_run;
    add_waypoints(preview, plan);
    add_check(preview, robot_.ask_about(plan));
    shown_.publish(preview);
  });
}

}  // namespace scan_cell
