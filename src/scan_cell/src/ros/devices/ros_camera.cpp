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

SetAcquisition::Response RosCamera::set_acquisition(std::uint8_t mode, double timeout,
                                                    const std::optional<Settings>& settings) const {
  SetAcquisition::Request request;
  request.mode = mode;
  request.trigger = SetAcquisition::Request::EXTERNAL_TRIGGER;
  request.change_settings = static_cast<unsigned char>(settings.has_value());
  request.settings = settings.value_or(Settings());
  return call<SetAcquisition>(parameters_.camera + "/set_acquisition", request, timeout);
}

void RosCamera::start(const PassCamera& settings) {
  silence_allowed_ = 0;
  const bool changes = before_ || !settings.empty();
  if (changes) wait_for_late_profiles();
  if (changes && !before_)
    before_ = set_acquisition(SetAcquisition::Request::STOP, parameters_.call_timeout).settings;
  const auto wanted = changes ? std::optional(changed_to(settings)) : std::nullopt;
  const auto answer =
      set_acquisition(SetAcquisition::Request::RELIEF_ONLY, parameters_.call_timeout, wanted);
  exposure_ = answer.taken.exposure > 0 ? answer.taken.exposure : answer.settings.exposure;
}

RosCamera::Settings RosCamera::changed_to(const PassCamera& settings) const {
  Settings changed = *before_;
  if (settings.exposure && changed.exposure <= 0) {
    throw scan_cell_common::Refused(
        "camera", "it uses its own exposure, which could not be restored afterwards",
        "start its node with the parameter exposure");
  }
  changed.exposure = settings.exposure.value_or(changed.exposure);
  if (!settings.detector.empty()) changed.detector = settings.detector;
  if (!settings.region) return changed;
  changed.region_x = settings.region->x;
  changed.region_y = settings.region->y;
  changed.region_width = settings.region->width;
  changed.region_height = settings.region->height;
  return changed;
}

/// Waits for profiles of the previous pass, since a stopped camera drops what it has not sent.
void RosCamera::wait_for_late_profiles() const {
  constexpr double kQuiet = 0.2;   // [s] without one; chosen, longer than a frame's way
  constexpr double kLongest = 1;   // [s] chosen
  constexpr double kLook = 0.005;  // [s] chosen
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kLongest);
  while (profile_.age() < kQuiet && ros::WallTime::now() < deadline)
    ros::WallDuration(kLook).sleep();
}

void RosCamera::expect_profiles(double rate) {
  profile_.now();
  silence_allowed_ = rate > 0 ? parameters_.silence_allowed(rate) : 0;
}

void RosCamera::stop() noexcept {
  constexpr double kTimeout = 0.5;  // [s] chosen: a lost camera may not answer for seconds
  silence_allowed_ = 0;
  try {
    set_acquisition(SetAcquisition::Request::STOP, kTimeout);
  } catch (const scan_cell_common::Error& error) {
    ROS_WARN("The camera was not stopped: %s", error.what());
  }
}

std::string RosCamera::restore() noexcept {
  if (!before_) return "";
  try {
    set_acquisition(SetAcquisition::Request::STOP, parameters_.call_timeout, before_);
  } catch (const scan_cell_common::Error& error) {
    return "camera: exposure, region and detector are not as before; the next scan tries again: " +
           std::string(error.what());
  }
  before_.reset();
  return "";
}

}  // namespace scan_cell
