// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "binder_services.h"
#include "scan_cell_common/ros/services.h"

int main(int argc, char** argv) {
  using namespace pose_frame_binder;  // NOLINT
  return scan_cell_common::services_main<BinderServices, Parameters>(
      argc, argv, "pose_frame_binder",
      "Finds the robot pose that belongs to each frame of the camera.");
}
