// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>
#include <scan_cell_common/ros/conversions.h>
#include <scan_cell_common/ros/node_main.h>
#include <scan_cell_common/ros/parameter_reader.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include "teaching/calibrated_frames.h"

namespace {

struct Parameters {
  std::string scanner_file;  //!< scanner.yaml
  std::string cell_file;     //!< cell.yaml

  static Parameters load(const ros::NodeHandle& node) {
    scan_cell_common::ParameterReader reader(node);
    Parameters parameters;
    reader.require("scanner_file", parameters.scanner_file);
    reader.require("cell_file", parameters.cell_file);
    reader.refuse_unknown();
    return parameters;
  }
};

void publish(const std::vector<scan_calibration::StaticFrame>& frames) {
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const scan_calibration::StaticFrame& frame : frames) {
    geometry_msgs::TransformStamped transform;
    transform.header.stamp = ros::Time::now();
    transform.header.frame_id = frame.parent;
    transform.child_frame_id = frame.child;
    transform.transform = scan_cell_common::to_ros_transform(frame.pose);
    transforms.push_back(transform);
  }
  tf2_ros::StaticTransformBroadcaster broadcaster;
  broadcaster.sendTransform(transforms);
  ros::spin();
}

}  // namespace

int main(int argc, char** argv) {
  return scan_cell_common::node_main(
      argc, argv, "calibrated_frames",
      "Publishes the calibrated frames of scanner, tool and world as static transforms.", [] {
        const Parameters parameters = Parameters::load(ros::NodeHandle("~"));
        publish(scan_calibration::calibrated_frames(
            scan_cell_common::load_scanner_model(parameters.scanner_file),
            scan_calibration::load_cell(parameters.cell_file)));
      });
}
