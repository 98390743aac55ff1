// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dynamic_reconfigure/Config.h>
#include <ros/node_handle.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <sensor_msgs/Image.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "devices/parameters.h"
#include "sequence/devices.h"

namespace scan_cell {

/// The camera behind a node with tecnogamma_camera's interface, in its mode RELIEF_LIVE: an image
/// and a profile belong together by their stamp, and to a start by its number.
class RosSnapshotCamera : public SnapshotCamera {
 public:
  RosSnapshotCamera(ros::NodeHandle node, const Parameters& parameters);

  void prepare() override;
  void start(double exposure) override;
  std::optional<Snapshot> snapshot() override;
  void stop() noexcept override;
  std::string restore() noexcept override;

 private:
  /// What it is set to outside a session.
  struct Settings {
    double exposure = 0;  // [s]
    int region_x = 0;     // [px]
    int region_y = 0;
    int region_width = 0;
    int region_height = 0;
  };

  std::uint32_t set_acquisition(std::uint8_t mode, double timeout) const;
  Settings read() const;
  void write(const Settings& settings) const;
  dynamic_reconfigure::Config reconfigure(const dynamic_reconfigure::Config& changes) const;
  void on_profile(const scan_cell_msgs::PeakProfileConstPtr& profile);
  void on_image(const sensor_msgs::ImageConstPtr& image);

  ros::NodeHandle node_;
  const Parameters parameters_;
  std::optional<Settings> before_;  // prepare(); none: nothing to restore
  std::mutex mutex_;                // of what follows
  std::uint32_t acquisition_ = 0;   // the start that counts
  std::map<ros::Time, scan_cell_msgs::PeakProfileConstPtr> profiles_;
  std::map<ros::Time, sensor_msgs::ImageConstPtr> images_;
  ros::Subscriber profile_subscriber_;  // last, as the other one: their callbacks use all the rest
  ros::Subscriber image_subscriber_;
};

}  // namespace scan_cell
