// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "devices/ros_devices.h"
#include "devices/ros_snapshot_camera.h"

namespace scan_cell {

/// The devices shared by the cell's actions.
struct CellDevices {
  CellDevices(const ros::NodeHandle& node, const Parameters& parameters)
      : robot(node, parameters),
        camera(node, parameters),
        snapshots(node, parameters),
        trigger(node, parameters) {}

  RosRobot robot;
  RosCamera camera;
  RosSnapshotCamera snapshots;  // the same camera
  RosTrigger trigger;
};

}  // namespace scan_cell
