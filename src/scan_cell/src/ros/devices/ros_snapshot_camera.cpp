// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "devices/ros_snapshot_camera.h"

#include <cv_bridge/cv_bridge.h>

#include "scan_cell/ros/service_call.h"

namespace scan_cell {

using scan_cell_common::Refused;
using scan_cell_msgs::SetAcquisition;

namespace {

constexpr std::uint32_t kQueue = 20;  // frames of which only one half has arrived

/// @throw UnusableInput if the message does not hold the image that it describes
cv::Mat pixels_of(const sensor_msgs::ImageConstPtr& image) {
  try {
    return cv_bridge::toCvCopy(image)->image;
  } catch (const std::exception& error) {  // from cv_bridge or OpenCV
    throw scan_cell_common::UnusableInput("image of encoding '" + image->encoding + "'",
                                          error.what(), "look at the camera's node");
  }
}

}  // namespace

RosSnapshotCamera::RosSnapshotCamera(ros::NodeHandle node, const Parameters& parameters)
    : node_(node), parameters_(parameters), frames_(profiles_, images_, kQueue) {
  frames_.registerCallback(&RosSnapshotCamera::on_frame, this);
}

void RosSnapshotCamera::prepare() {
  before_.reset();
  const Settings before =
      set_acquisition(SetAcquisition::Request::STOP, parameters_.call_timeout).settings;
  if (before.exposure <= 0) {
    throw Refused("camera", "it uses its own exposure, which could not be restored afterwards",
                  "start its node with the parameter exposure");
  }
  before_ = before;
  Settings whole_sensor;
  whole_sensor.exposure = before.exposure;
  set_acquisition(SetAcquisition::Request::STOP, parameters_.call_timeout, whole_sensor);
  profiles_.subscribe(node_, parameters_.camera + "/profiles", kQueue);
  images_.subscribe(node_, parameters_.camera + "/image_raw", kQueue);
}

void RosSnapshotCamera::start(double exposure) {
  Settings whole_sensor;
  whole_sensor.exposure = exposure;
  whole_sensor.live_ratio = 1;
  const std::uint32_t acquisition =
      set_acquisition(SetAcquisition::Request::RELIEF_LIVE, parameters_.call_timeout, whole_sensor)
          .acquisition;
  const std::lock_guard<std::mutex> lock(mutex_);
  acquisition_ = acquisition;
  profile_.reset();
  image_.reset();
}

std::optional<Snapshot> RosSnapshotCamera::snapshot() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!profile_) return std::nullopt;
  Snapshot snapshot;
  snapshot.image = pixels_of(image_);
  snapshot.peaks.first_row = static_cast<int>(profile_->first_row);
  snapshot.peaks.position = profile_->position;
  snapshot.peaks.width = profile_->width;
  snapshot.peaks.intensity = profile_->intensity;
  return snapshot;
}

void RosSnapshotCamera::stop() noexcept {
  constexpr double kTimeout = 2;  // [s] a lost camera may not answer for longer; chosen
  try {
    set_acquisition(SetAcquisition::Request::STOP, kTimeout);
  } catch (const scan_cell_common::Error& error) {
    ROS_WARN("The camera was not stopped: %s", error.what());
  }
}

std::string RosSnapshotCamera::restore() noexcept {
  profiles_.unsubscribe();
  images_.unsubscribe();
  if (!before_) return "";
  try {
    set_acquisition(SetAcquisition::Request::STOP, parameters_.call_timeout, before_);
  } catch (const scan_cell_common::Error& error) {
    return "camera: region and exposure are not as before; restart its node: " +
           std::string(error.what());
  }
  return "";
}

SetAcquisition::Response RosSnapshotCamera::set_acquisition(
    std::uint8_t mode, double timeout, const std::optional<Settings>& settings) const {
  SetAcquisition::Request request;
  request.mode = mode;
  request.trigger = SetAcquisition::Request::EXTERNAL_TRIGGER;
  request.change_settings = settings.has_value();
  request.settings = settings.value_or(Settings());
  return call<SetAcquisition>(parameters_.camera + "/set_acquisition", request, timeout);
}

void RosSnapshotCamera::on_frame(const scan_cell_msgs::PeakProfileConstPtr& profile,
                                 const sensor_msgs::ImageConstPtr& image) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (profile_ || profile->acquisition != acquisition_ || profile->packets_lost > 0) return;
  profile_ = profile;
  image_ = image;
}

}  // namespace scan_cell
