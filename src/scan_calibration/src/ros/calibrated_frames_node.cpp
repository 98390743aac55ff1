// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>
#include <scan_cell_common/ros/conversions.h>
#include <scan_cell_common/ros/load_parameters.h>
#include <scan_cell_common/ros/node_main.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include "calibrated_frames_parameters.h"
#include "light_sheets.h"
#include "teaching/calibrated_frames.h"

namespace {

using Parameters = scan_calibration::CalibratedFramesParameters;

void publish(tf2_ros::StaticTransformBroadcaster& broadcaster,
             const std::vector<scan_calibration::StaticFrame>& frames) {
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const scan_calibration::StaticFrame& frame : frames) {
    geometry_msgs::TransformStamped transform;
    transform.header.stamp = ros::Time::now();
    transform.header.frame_id = frame.parent;
    transform.child_frame_id = frame.child;
    transform.transform = scan_cell_common::to_ros_transform(frame.pose);
    transforms.push_back(transform);
  }
  broadcaster.sendTransform(transforms);
}

void serve(const Parameters& parameters) {
  const auto scanner = scan_cell_common::load_scanner_model(parameters.scanner_file);
  const auto cell = scan_calibration::load_cell(parameters.cell_file);
  tf2_ros::StaticTransformBroadcaster broadcaster;
  publish(broadcaster, scan_calibration::calibrated_frames(scanner, cell));
  const scan_calibration::LightSheets sheets(scanner, parameters.light_sheet);
  ros::spin();
}

}  // namespace

int main(int argc, char** argv) {
  return scan_cell_common::node_main<Parameters>(
      argc, argv, "calibrated_frames",
      "Publishes the calibrated frames of scanner, tool and world as static transforms, and the "
      "sheets of light of the lasers that are on.",
      [] { serve(scan_cell_common::load_parameters<Parameters>(ros::NodeHandle("~"))); });
}
