// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "services/record_pose.h"

#include <filesystem>

#include "scan_calibration/taught_poses.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"
#include "scan_cell_common/ros/service_answer.h"

namespace scan_cell {

RecordPose::RecordPose(ros::NodeHandle node, const std::string& base_frame, Robot& robot)
    : base_frame_(base_frame),
      robot_(robot),
      server_(node.advertiseService("record_pose", &RecordPose::serve, this)) {}

bool RecordPose::serve(scan_cell_msgs::RecordPose::Request& request,
                       scan_cell_msgs::RecordPose::Response& response) {
  return scan_cell_common::answer(response, [&] {
    if (!std::filesystem::path(request.file).is_absolute()) {
      throw scan_cell_common::Refused("file", "'" + request.file + "'",
                                      "give an absolute path: the cell runs in its own folder");
    }
    const Eigen::Isometry3d flange = robot_.static_pose();
    response.poses =
        static_cast<std::uint32_t>(scan_calibration::append_taught_pose(request.file, flange));
    response.pose.header.frame_id = base_frame_;
    response.pose.header.stamp = ros::Time::now();
    response.pose.pose = scan_cell_common::to_ros_pose(flange);
  });
}

}  // namespace scan_cell
