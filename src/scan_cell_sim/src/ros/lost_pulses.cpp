// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lost_pulses.h"

namespace scan_cell_sim {

LostPulses::LostPulses(ros::NodeHandle node, const GigeCamera& camera, const CameraOptions& options)
    : camera_(camera),
      options_(options),
      timer_(node.createWallTimer(ros::WallDuration(1), &LostPulses::look, this)) {}

void LostPulses::look(const ros::WallTimerEvent&) {
  const GigeCamera::Counts now = camera_.counts();
  if (now.too_soon > said_.too_soon) {
    ROS_WARN(
        "camera: %lu pulses lost; less than %g s after the one before (camera/min_period); "
        "lower the rate, or other work on this computer delays the trigger",
        now.too_soon - said_.too_soon, options_.min_period);
  }
  if (now.queue_full > said_.queue_full) {
    ROS_WARN(
        "camera: %lu pulses lost; %d frames are still to be drawn (camera/max_pending); "
        "this computer is too busy: stop other work, or lower the rate",
        now.queue_full - said_.queue_full, options_.max_pending);
  }
  said_ = now;
}

}  // namespace scan_cell_sim
