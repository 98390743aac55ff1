// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "camera_nodelet.h"

#include <fmt/format.h>

#include <boost/make_shared.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "bag_recording.h"
#include "diagnostics.h"
#include "messages.h"
#include "scan_cell_common/ros/load_parameters.h"
#include "scan_cell_common/ros/service_answer.h"

namespace tecnogamma_camera {
namespace {

using Request = scan_cell_msgs::SetAcquisition::Request;

Region region_of(const CameraConfig& config) {
  return {config.region_x, config.region_y, config.region_width, config.region_height};
}

void set_region(CameraConfig& config, const Region& region) {
  config.region_x = region.x;
  config.region_y = region.y;
  config.region_width = region.width;
  config.region_height = region.height;
}

void check_word(const char* name, std::uint8_t value, std::uint8_t most) {
  if (value <= most) return;
  throw scan_cell_common::InvalidParameter(name, fmt::format("{}", value),
                                           "give a constant of SetAcquisition");
}

}  // namespace

void CameraNodelet::start() {
  parameters_ = scan_cell_common::load_parameters<Parameters>(getPrivateNodeHandle());
  if (!parameters_.scanner_model.empty())
    model_ = scan_cell_common::load_scanner_model(parameters_.scanner_model);
  tuning_ = parameters_.tuning;
  detector_ = make_detector(tuning_.detector, tuning_.detection);
  advertise();
  acquisition_ = std::make_unique<Acquisition>(
      parameters_.acquisition,
      [this] { return open_camera(parameters_.camera, parameters_.source, recordings()); }, *this);
  start_reconfigure();
  // A start may wait for the camera; the diagnostics continue on the other queue.
  set_acquisition_ = getMTPrivateNodeHandle().advertiseService(
      "set_acquisition", &CameraNodelet::set_acquisition, this);
  constexpr double kDiagnosticsPeriod = 1;  // [s] chosen
  diagnostics_timer_ = getNodeHandle().createWallTimer(ros::WallDuration(kDiagnosticsPeriod),
                                                       &CameraNodelet::publish_diagnostics, this);
}

void CameraNodelet::advertise() {
  ros::NodeHandle node = getPrivateNodeHandle();
  constexpr int kProfileQueue = 1000;  // messages: two seconds at 500 Hz; chosen
  constexpr int kImageQueue = 10;      // messages; chosen
  profiles_ = node.advertise<scan_cell_msgs::PeakProfile>("profiles", kProfileQueue);
  images_ = node.advertise<sensor_msgs::Image>("image_raw", kImageQueue);
  camera_infos_ = node.advertise<sensor_msgs::CameraInfo>("camera_info", kImageQueue);
  frame_infos_ = node.advertise<scan_cell_msgs::FrameInfo>("frame_info", kImageQueue);
  diagnostics_ = std::make_unique<diagnostic_updater::Updater>(getNodeHandle(),
                                                               getPrivateNodeHandle(), getName());
  diagnostics_->setHardwareID(parameters_.camera.empty() ? "any camera" : parameters_.camera);
  diagnostics_->add("camera", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
    const AcquisitionState now = acquisition_->state();
    write_diagnostics(diagnosed_, now, fault_of_model(now.camera), status);
    diagnosed_ = now;
  });
}

RecordingKinds CameraNodelet::recordings() const {
  const std::string topic = parameters_.bag_topic;
  return {{"bag", [topic](const std::string& path) { return open_bag_recording(path, topic); }}};
}

void CameraNodelet::start_reconfigure() {
  reconfigure_ = std::make_unique<dynamic_reconfigure::Server<CameraConfig>>(
      reconfigure_mutex_, getMTPrivateNodeHandle());
  config_.__fromServer__(getPrivateNodeHandle());
  reconfigure_->setCallback([this](CameraConfig& config, std::uint32_t) { reconfigure(config); });
}

void CameraNodelet::on_connected(const CameraDescription& camera) {
  NODELET_INFO("camera %s found: %d x %d pixels, region %d x %d at %d, %d", camera.id.c_str(),
               camera.sensor_columns, camera.sensor_rows, camera.region.width, camera.region.height,
               camera.region.x, camera.region.y);
  const std::string fault = fault_of_model(camera);
  if (!fault.empty()) NODELET_ERROR("%s", fault.c_str());
  const int greatest = (1 << camera.grey_bits) - 1;
  const int level = tuning().detection.trigger_level;
  if (level >= greatest) {
    NODELET_ERROR("trigger_level: %d; grey values end at %d: no row will have a peak", level,
                  greatest);
  }
}

std::string CameraNodelet::fault_of_model(const CameraDescription& camera) const {
  return model_ ? find_fault(*model_, camera) : "";
}

void CameraNodelet::on_ended(const std::string& recording) {
  NODELET_INFO("%s", recording.c_str());
}

void CameraNodelet::on_trouble(const std::string& reason) {
  NODELET_ERROR("%s", reason.c_str());
}

void CameraNodelet::on_frame(const NumberedFrame& frame) {
  const bool live_only = frame.mode == AcquisitionMode::kLiveOnly;
  if (!live_only) publish_profile(frame);
  if (!frame.frame.image.pixels) return;
  const bool with_image = live_only || (frame.mode == AcquisitionMode::kReliefLive &&
                                        profiles_to_image_++ % tuning().live_ratio == 0);
  if (with_image) publish_image(frame);
}

void CameraNodelet::publish_profile(const NumberedFrame& frame) {
  std::shared_ptr<const PeakDetector> detector;
  {
    const std::lock_guard<std::mutex> lock(detector_mutex_);
    detector = detector_;
  }
  PeakProfile profile;
  const GreyImage& image = frame.frame.image;
  if (frame.frame.peaks) {
    profile = *frame.frame.peaks;
  } else if (image.pixels) {
    detector->detect(image, profile);
  } else {
    profile.clear(image.first_row, image.rows);
  }
  profiles_.publish(to_message(frame, parameters_.frame_id, std::move(profile)));
}

void CameraNodelet::publish_image(const NumberedFrame& frame) {
  if (images_.getNumSubscribers() + camera_infos_.getNumSubscribers() +
          frame_infos_.getNumSubscribers() ==
      0) {
    return;
  }
  const sensor_msgs::ImagePtr image = to_image_message(frame, parameters_.frame_id);
  const auto info = boost::make_shared<sensor_msgs::CameraInfo>(
      to_camera_info(frame.camera, model_ ? &*model_ : nullptr, parameters_.frame_id));
  info->header = image->header;
  set_region(frame, *info);  // a smart camera's may change from frame to frame
  images_.publish(image);
  camera_infos_.publish(info);
  frame_infos_.publish(to_frame_info(frame, parameters_.frame_id));
}

bool CameraNodelet::set_acquisition(Request& request,
                                    scan_cell_msgs::SetAcquisition::Response& response) {
  scan_cell_common::answer(response, [&] {
    check_word("mode", request.mode, Request::RELIEF_LIVE);
    check_word("trigger", request.trigger, Request::EXTERNAL_TRIGGER);
    const auto mode = static_cast<AcquisitionMode>(request.mode);
    const auto trigger =
        request.trigger == Request::FREE_RUN ? Trigger::kFreeRun : Trigger::kExternal;
    response.acquisition = request.change_settings ? set_and_show(mode, trigger, request.settings)
                                                   : acquisition_->set(mode, trigger);
  });
  const AcquisitionState now = acquisition_->state();
  response.settings = to_message(now.settings, tuning());
  if (now.connected) response.taken = to_message(now.camera.exposure, now.camera.region);
  return true;
}

std::uint32_t CameraNodelet::set_and_show(AcquisitionMode mode, Trigger trigger,
                                          const scan_cell_msgs::CameraSettings& settings) {
  const boost::lock_guard<boost::recursive_mutex> lock(reconfigure_mutex_);
  CameraChange change = from_message(settings);
  const Tuning tuned = changed(tuning(), settings);
  make_detector(tuned.detector, tuned.detection);  // refused before anything is written
  change.on_taken = [this, &tuned] { tune(tuned); };
  try {
    const std::uint32_t acquisition = acquisition_->set(mode, trigger, change);
    show(acquisition_->state().settings);
    return acquisition;
  } catch (const scan_cell_common::Error&) {
    show(acquisition_->state().settings);  // they may have been applied before the start failed
    throw;
  }
}

Tuning CameraNodelet::tuning() const {
  const std::lock_guard<std::mutex> lock(detector_mutex_);
  return tuning_;
}

void CameraNodelet::tune(const Tuning& tuning) {
  std::shared_ptr<const PeakDetector> detector = make_detector(tuning.detector, tuning.detection);
  const std::lock_guard<std::mutex> lock(detector_mutex_);
  detector_ = std::move(detector);
  tuning_ = tuning;
}

/// Shows the settings in dynamic_reconfigure.
void CameraNodelet::show(const CameraSettings& settings) {
  const Tuning now = tuning();
  config_.detector = now.detector;
  config_.choice = choice_names().at(static_cast<std::size_t>(now.detection.choice));
  config_.live_ratio = now.live_ratio;
  config_.exposure = settings.exposure.value_or(0);
  set_region(config_, settings.region);
  reconfigure_->updateConfig(config_);
}

void CameraNodelet::reconfigure(CameraConfig& config) {
  change_tuning(config);
  change_exposure(config);
  change_region(config);
  config_ = config;
}

void CameraNodelet::change_tuning(CameraConfig& config) {
  Tuning tuned = tuning();
  tuned.live_ratio = config.live_ratio;
  tuned.detection.trigger_level = config.trigger_level;
  tuned.detection.permanence = config.permanence;
  tuned.detection.window = config.window;
  tuned.detection.max_width = config.max_width;
  try {
    tuned.detector = config.detector;
    tuned.detection.choice = choice_of(config.choice);
    tune(tuned);
  } catch (const scan_cell_common::Error& error) {
    NODELET_ERROR("detector not changed: %s", error.what());
    config.detector = config_.detector;
    config.choice = config_.choice;
    config.live_ratio = config_.live_ratio;
    config.trigger_level = config_.trigger_level;
    config.permanence = config_.permanence;
    config.window = config_.window;
    config.max_width = config_.max_width;
  }
}

void CameraNodelet::change_exposure(CameraConfig& config) {
  if (config.exposure == config_.exposure) return;
  try {
    if (config.exposure == 0) {
      throw scan_cell_common::Refused("exposure",
                                      "0 s: the camera's own exposure has been overwritten",
                                      "give a value above 0, or restart the camera and the node");
    }
    acquisition_->set_exposure(config.exposure);
  } catch (const scan_cell_common::Error& error) {
    NODELET_ERROR("exposure not changed: %s", error.what());
    config.exposure = config_.exposure;
  }
}

void CameraNodelet::change_region(CameraConfig& config) {
  if (region_of(config) == region_of(config_)) return;
  try {
    acquisition_->set_region(region_of(config));
  } catch (const scan_cell_common::Error& error) {
    NODELET_ERROR("region not changed: %s", error.what());
    set_region(config, region_of(config_));
  }
}

void CameraNodelet::publish_diagnostics(const ros::WallTimerEvent&) {
  diagnostics_->force_update();
}

}  // namespace tecnogamma_camera

PLUGINLIB_EXPORT_CLASS(tecnogamma_camera::CameraNodelet, nodelet::Nodelet)
