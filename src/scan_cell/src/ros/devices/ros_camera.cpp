// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <scan_cell_msgs/SetAcquisition.h>

#include "devices/ros_devices.h"
#include "scan_cell/ros/service_call.h"

namespace scan_cell {

using scan_cell_msgs::SetAcquisition;

RosCamera::RosCamera(ros::NodeHandle node, const Parameters& parameters) : parameters_(parameters) {
  const boost::function<void(const scan_cell_msgs::PeakProfileConstPtr&)> heard =
      [this](const scan_cell_msgs::PeakProfileConstPtr&) {
        profile_.now();
        ++profiles_;
      };
  subscriber_ =
      node.subscribe<scan_cell_msgs::PeakProfile>(parameters.camera + "/profiles", 1000, heard);
}

std::string RosCamera::trouble() const {
  if (silence_allowed_ <= 0 || profile_.age() <= silence_allowed_) return "";
  return fmt::format(
      "camera: no profile for {:g} s after {} of this scan; check the camera's cable and trigger "
      "input",
      profile_.age(), profiles_);
}

void RosCamera::set_acquisition(std::uint8_t mode, double timeout) const {
  SetAcquisition::Request request;
  request.mode = mode;
  request.trigger = SetAcquisition::Request::EXTERNAL_TRIGGER;
  call<SetAcquisition>(parameters_.camera + "/set_acquisition", request, timeout);
}

void RosCamera::start() {
  silence_allowed_ = 0;
  set_acquisition(SetAcquisition::Request::RELIEF_ONLY, parameters_.call_timeout);
}

void RosCamera::expect_profiles(double rate) {
  profile_.now();
  silence_allowed_ = rate > 0 ? parameters_.silence_allowed(rate) : 0;
}

void RosCamera::stop() noexcept {
  constexpr double kTimeout = 0.5;  // [s] chosen: a camera that was lost may not answer for seconds
  silence_allowed_ = 0;
  try {
    set_acquisition(SetAcquisition::Request::STOP, kTimeout);
  } catch (const scan_cell_common::Error& error) {
    ROS_WARN("The camera was not stopped: %s", error.what());
  }
}

}  // namespace scan_cell
