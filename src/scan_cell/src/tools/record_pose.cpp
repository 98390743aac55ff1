// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <scan_cell_msgs/RecordPose.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/ros/node_main.h"

namespace {

/// @throw Refused if the robot moves, or the file is not a file of poses
void record(const std::string& file, const std::string& cell, double timeout) {
  scan_cell_msgs::RecordPose::Request request;
  request.file = std::filesystem::absolute(file).lexically_normal().string();
  const auto answer =
      scan_cell::call<scan_cell_msgs::RecordPose>(cell + "/record_pose", request, timeout);
  const geometry_msgs::Point& p = answer.pose.pose.position;
  const geometry_msgs::Quaternion& q = answer.pose.pose.orientation;
  std::printf("%s: pose %u: %.6f %.6f %.6f m, rotation %.6f %.6f %.6f %.6f, in %s\n",
              request.file.c_str(), answer.poses, p.x, p.y, p.z, q.x, q.y, q.z, q.w,
              answer.pose.header.frame_id.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  std::string file;
  std::string cell = "/scan_cell";
  double timeout = 10;
  CLI::App app("Appends the pose in which the robot stands now to a file of taught poses");
  app.add_option("--poses", file, "file of taught poses (CSV), created if there is none")
      ->required();
  app.add_option("--cell", cell, "node that directs the cell")->capture_default_str();
  app.add_option("--timeout", timeout, "seconds to wait for the cell")->capture_default_str();
  return scan_cell_common::ros_tool_main(
      "record_pose", app, argc, argv,
      [&] {
        record(file, cell, timeout);
        return 0;
      },
      scan_cell_common::kRefused);
}
