// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <message_filters/subscriber.h>
#include <message_filters/time_synchronizer.h>
#include <ros/node_handle.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <scan_cell_msgs/SetAcquisition.h>
#include <sensor_msgs/Image.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "parameters/parameters.h"
#include "sequence/devices.h"

namespace scan_cell {

/// The camera behind a node with tecnogamma_camera's interface, in its mode RELIEF_LIVE: an image
/// and a profile are matched by their stamp, and to a start by its number.
class RosSnapshotCamera : public SnapshotCamera {
 public:
  RosSnapshotCamera(ros::NodeHandle node, const Parameters& parameters);

  void prepare() override;
  void start(double exposure) override;
  std::optional<Snapshot> snapshot() override;
  void stop() noexcept override;
  std::string restore() noexcept override;

 private:
  using Settings = scan_cell_msgs::CameraSettings;

  /// @param settings none: they stay unchanged
  scan_cell_msgs::SetAcquisition::Response set_acquisition(
      std::uint8_t mode, double timeout, const std::optional<Settings>& settings = {}) const;
  void on_frame(const scan_cell_msgs::PeakProfileConstPtr& profile,
                const sensor_msgs::ImageConstPtr& image);

  ros::NodeHandle node_;
  const Parameters parameters_;
  std::optional<Settings> before_;               // outside a session; none: nothing to restore
  std::mutex mutex_;                             // guards all that follows
  std::uint32_t acquisition_ = 0;                // the present start
  scan_cell_msgs::PeakProfileConstPtr profile_;  // of its first whole frame, like the image
  sensor_msgs::ImageConstPtr image_;
  message_filters::Subscriber<scan_cell_msgs::PeakProfile> profiles_;
  message_filters::Subscriber<sensor_msgs::Image> images_;
  message_filters::TimeSynchronizer<scan_cell_msgs::PeakProfile, sensor_msgs::Image> frames_;
};

}  // namespace scan_cell
