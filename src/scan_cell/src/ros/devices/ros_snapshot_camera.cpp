// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "devices/ros_snapshot_camera.h"

#include <cv_bridge/cv_bridge.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <scan_cell_msgs/SetAcquisition.h>

#include <algorithm>
#include <cmath>

#include "scan_cell/ros/service_call.h"

namespace scan_cell {

using scan_cell_common::Refused;
using scan_cell_msgs::SetAcquisition;

namespace {

constexpr std::size_t kMostWaiting = 20;  // frames kept of which only half has come

template <class Message>
void keep(std::map<ros::Time, Message>& waiting, const Message& message) {
  waiting[message->header.stamp] = message;
  if (waiting.size() > kMostWaiting) waiting.erase(waiting.begin());
}

/// @throw Refused if the camera's node has no such parameter
template <class Parameters>
auto find(const Parameters& parameters, const std::string& name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const auto& one) { return one.name == name; });
  if (found == parameters.end()) {
    throw Refused("camera", "no parameter " + name,
                  "use a node with tecnogamma_camera's interface");
  }
  return found->value;
}

/// @throw UnusableInput if the message does not hold the image that it says
cv::Mat pixels_of(const sensor_msgs::ImageConstPtr& image) {
  try {
    return cv_bridge::toCvCopy(image)->image;
  } catch (const std::exception& error) {  // of cv_bridge, or of OpenCV
    throw scan_cell_common::UnusableInput("image of encoding '" + image->encoding + "'",
                                          error.what(), "look at the camera's node");
  }
}

template <class Parameter, class Value>
Parameter named(const std::string& name, Value value) {
  Parameter parameter;
  parameter.name = name;
  parameter.value = value;
  return parameter;
}

}  // namespace

RosSnapshotCamera::RosSnapshotCamera(ros::NodeHandle node, const Parameters& parameters)
    : node_(node), parameters_(parameters) {}

void RosSnapshotCamera::prepare() {
  before_.reset();
  set_acquisition(SetAcquisition::Request::STOP, parameters_.call_timeout);
  const Settings before = read();
  if (before.exposure <= 0) {
    throw Refused("camera", "its exposure is its own, and could not be restored afterwards",
                  "start its node with the parameter exposure");
  }
  before_ = before;
  Settings whole_sensor;
  whole_sensor.exposure = before.exposure;
  write(whole_sensor);
  constexpr std::uint32_t kQueue = 20;
  profile_subscriber_ = node_.subscribe(parameters_.camera + "/profiles", kQueue,
                                        &RosSnapshotCamera::on_profile, this);
  image_subscriber_ = node_.subscribe(parameters_.camera + "/image_raw", kQueue,
                                      &RosSnapshotCamera::on_image, this);
}

void RosSnapshotCamera::start(double exposure) {
  Settings settings;
  settings.exposure = exposure;
  write(settings);
  const std::uint32_t acquisition =
      set_acquisition(SetAcquisition::Request::RELIEF_LIVE, parameters_.call_timeout);
  const std::lock_guard<std::mutex> lock(mutex_);
  acquisition_ = acquisition;
  profiles_.clear();
  images_.clear();
}

std::optional<Snapshot> RosSnapshotCamera::snapshot() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [stamp, profile] : profiles_) {
    const auto image = images_.find(stamp);
    if (image == images_.end()) continue;
    Snapshot snapshot;
    snapshot.image = pixels_of(image->second);
    snapshot.peaks.first_row = static_cast<int>(profile->first_row);
    snapshot.peaks.position = profile->position;
    snapshot.peaks.width = profile->width;
    snapshot.peaks.intensity = profile->intensity;
    return snapshot;
  }
  return std::nullopt;
}

void RosSnapshotCamera::stop() noexcept {
  constexpr double kTimeout = 2;  // [s] a camera that was lost may not answer for longer
  try {
    set_acquisition(SetAcquisition::Request::STOP, kTimeout);
  } catch (const scan_cell_common::Error& error) {
    ROS_WARN("The camera was not stopped: %s", error.what());
  }
}

std::string RosSnapshotCamera::restore() noexcept {
  profile_subscriber_.shutdown();
  image_subscriber_.shutdown();
  if (!before_) return "";
  try {
    set_acquisition(SetAcquisition::Request::STOP, parameters_.call_timeout);
    write(*before_);
  } catch (const scan_cell_common::Error& error) {
    return "camera: region and exposure are not as before; restart its node: " +
           std::string(error.what());
  }
  return "";
}

std::uint32_t RosSnapshotCamera::set_acquisition(std::uint8_t mode, double timeout) const {
  SetAcquisition::Request request;
  request.mode = mode;
  request.trigger = SetAcquisition::Request::EXTERNAL_TRIGGER;
  return call<SetAcquisition>(parameters_.camera + "/set_acquisition", request, timeout)
      .acquisition;
}

dynamic_reconfigure::Config RosSnapshotCamera::reconfigure(
    const dynamic_reconfigure::Config& changes) const {
  dynamic_reconfigure::Reconfigure::Request request;
  request.config = changes;
  return ask<dynamic_reconfigure::Reconfigure>(parameters_.camera + "/set_parameters", request,
                                               parameters_.call_timeout)
      .config;
}

RosSnapshotCamera::Settings RosSnapshotCamera::read() const {
  const dynamic_reconfigure::Config config = reconfigure({});
  Settings settings;
  settings.exposure = find(config.doubles, "exposure");
  settings.region_x = find(config.ints, "region_x");
  settings.region_y = find(config.ints, "region_y");
  settings.region_width = find(config.ints, "region_width");
  settings.region_height = find(config.ints, "region_height");
  return settings;
}

/// The node answers with what it is set to, whether or not it took the change.
void RosSnapshotCamera::write(const Settings& settings) const {
  using dynamic_reconfigure::DoubleParameter;
  using dynamic_reconfigure::IntParameter;
  dynamic_reconfigure::Config changes;
  changes.doubles = {named<DoubleParameter>("exposure", settings.exposure)};
  changes.ints = {named<IntParameter>("region_x", settings.region_x),
                  named<IntParameter>("region_y", settings.region_y),
                  named<IntParameter>("region_width", settings.region_width),
                  named<IntParameter>("region_height", settings.region_height)};
  const dynamic_reconfigure::Config taken = reconfigure(changes);
  for (const auto& change : changes.ints) {
    if (find(taken.ints, change.name) == change.value) continue;
    throw Refused("camera", "it did not take " + change.name + " " + std::to_string(change.value),
                  "look at its node's log");
  }
  if (find(taken.doubles, "exposure") != settings.exposure) {
    throw Refused("camera",
                  "it did not take an exposure of " + std::to_string(settings.exposure) + " s",
                  "look at its node's log");
  }
}

void RosSnapshotCamera::on_profile(const scan_cell_msgs::PeakProfileConstPtr& profile) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (profile->acquisition == acquisition_ && profile->packets_lost == 0) keep(profiles_, profile);
}

void RosSnapshotCamera::on_image(const sensor_msgs::ImageConstPtr& image) {
  const std::lock_guard<std::mutex> lock(mutex_);
  keep(images_, image);
}

}  // namespace scan_cell
