// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include "scan_cell_sim/gige_camera.h"

namespace scan_cell_sim {

/// Warns once a second at most of pulses that the simulated camera could not take, with the reason.
/// The cell itself sees only that their frames do not come.
class LostPulses {
 public:
  /// @param camera must outlive this
  LostPulses(ros::NodeHandle node, const GigeCamera& camera, const CameraOptions& options);

 private:
  void look(const ros::WallTimerEvent& event);

  const GigeCamera& camera_;
  const CameraOptions options_;
  GigeCamera::Counts said_;
  ros::WallTimer timer_;
};

}  // namespace scan_cell_sim
