// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "messages.h"

#include <fmt/format.h>
#include <sensor_msgs/distortion_models.h>
#include <sensor_msgs/image_encodings.h>

#include <boost/make_shared.hpp>
#include <cstring>

#include "scan_cell_common/ros/conversions.h"

namespace tecnogamma_camera {

using scan_cell_common::to_ros;

scan_cell_msgs::PeakProfilePtr to_message(const NumberedFrame& frame, const std::string& frame_id,
                                          PeakProfile&& profile) {
  const auto message = boost::make_shared<scan_cell_msgs::PeakProfile>();
  message->header.stamp = to_ros(frame.time);
  message->header.frame_id = frame_id;
  message->acquisition = frame.acquisition;
  message->frame_counter = frame.counter;
  message->device_time = static_cast<std::uint64_t>(frame.frame.device_time);
  message->laser = scan_cell_msgs::PeakProfile::LASER_UNKNOWN;
  message->packets_lost = frame.frame.packets_lost;
  message->first_row = static_cast<std::uint32_t>(profile.first_row);
  message->position = std::move(profile.position);
  message->width = std::move(profile.width);
  message->intensity = std::move(profile.intensity);
  return message;
}

sensor_msgs::ImagePtr to_image_message(const NumberedFrame& frame, const std::string& frame_id) {
  const GreyImage& image = frame.frame.image;
  const auto message = boost::make_shared<sensor_msgs::Image>();
  message->header.stamp = to_ros(frame.time);
  message->header.frame_id = frame_id;
  message->encoding = image.bytes_per_pixel() == 2 ? sensor_msgs::image_encodings::MONO16
                                                   : sensor_msgs::image_encodings::MONO8;
  message->width = image.columns;
  message->height = image.rows;
  message->step = image.columns * image.bytes_per_pixel();
  message->data.resize(static_cast<std::size_t>(message->step) * image.rows);
  visit(image, [&](const auto& view) {
    for (int row = 0; row < view.rows; ++row)
      std::memcpy(&message->data[static_cast<std::size_t>(row) * message->step], view.row(row),
                  message->step);
  });
  return message;
}

scan_cell_msgs::FrameInfoPtr to_frame_info(const NumberedFrame& frame,
                                           const std::string& frame_id) {
  const auto message = boost::make_shared<scan_cell_msgs::FrameInfo>();
  message->header.stamp = to_ros(frame.time);
  message->header.frame_id = frame_id;
  message->acquisition = frame.acquisition;
  message->frame_counter = frame.counter;
  message->device_time = static_cast<std::uint64_t>(frame.frame.device_time);
  message->packets_lost = frame.frame.packets_lost;
  message->first_column = static_cast<std::uint32_t>(frame.frame.image.first_column);
  message->first_row = static_cast<std::uint32_t>(frame.frame.image.first_row);
  message->decimation = 1;
  return message;
}

CameraChange from_message(const scan_cell_msgs::CameraSettings& settings) {
  using scan_cell_common::InvalidParameter;
  constexpr double kMaxExposure = 10;           // [s] as the parameter exposure
  constexpr std::uint32_t kMaxPixels = 65'535;  // [px] as the parameters of the region
  constexpr double kMaxRate = 1e5;              // [Hz] as the parameter rate
  constexpr double kMaxGain = 1000;             // as the parameter gain
  if (!(settings.rate >= 0 && settings.rate <= kMaxRate)) {
    throw InvalidParameter("rate", fmt::format("{} Hz", settings.rate),
                           fmt::format("give 0 .. {} Hz", kMaxRate));
  }
  if (settings.set_gain && !(settings.gain >= 0 && settings.gain <= kMaxGain)) {
    throw InvalidParameter("gain", fmt::format("{}", settings.gain),
                           fmt::format("give 0 .. {}", kMaxGain));
  }
  if (!(settings.exposure >= 0 && settings.exposure <= kMaxExposure)) {
    throw InvalidParameter("exposure", fmt::format("{} s", settings.exposure),
                           fmt::format("give 0 .. {} s", kMaxExposure));
  }
  const auto pixels = [&](const char* name, std::uint32_t value) {
    if (value <= kMaxPixels) return static_cast<int>(value);
    throw InvalidParameter(name, fmt::format("{} px", value),
                           fmt::format("give 0 .. {} px", kMaxPixels));
  };
  CameraChange change;
  change.exposure = settings.exposure;
  change.region = {pixels("region_x", settings.region_x), pixels("region_y", settings.region_y),
                   pixels("region_width", settings.region_width),
                   pixels("region_height", settings.region_height)};
  if (settings.rate > 0) change.rate = settings.rate;
  if (settings.set_gain) change.gain = settings.gain;
  return change;
}

Tuning changed(const Tuning& tuning, const scan_cell_msgs::CameraSettings& settings) {
  Tuning result = tuning;
  if (!settings.detector.empty()) result.detector = settings.detector;
  if (!settings.choice.empty()) result.detection.choice = choice_of(settings.choice);
  if (settings.live_ratio > kMaxLiveRatio) {
    throw scan_cell_common::InvalidParameter("live_ratio", fmt::format("{}", settings.live_ratio),
                                             fmt::format("give 1 .. {}", kMaxLiveRatio));
  }
  if (settings.live_ratio > 0) result.live_ratio = static_cast<int>(settings.live_ratio);
  return result;
}

scan_cell_msgs::CameraSettings to_message(const CameraSettings& settings, const Tuning& tuning) {
  scan_cell_msgs::CameraSettings message =
      to_message(settings.exposure.value_or(0), settings.region);
  message.rate = settings.rate.value_or(0);
  message.set_gain = static_cast<unsigned char>(settings.gain.has_value());
  message.gain = settings.gain.value_or(0);
  message.detector = tuning.detector;
  message.choice = choice_names().at(static_cast<std::size_t>(tuning.detection.choice));
  message.live_ratio = static_cast<std::uint32_t>(tuning.live_ratio);
  return message;
}

scan_cell_msgs::CameraSettings to_message(double exposure, const Region& region) {
  scan_cell_msgs::CameraSettings message;
  message.exposure = exposure;
  message.region_x = static_cast<std::uint32_t>(region.x);
  message.region_y = static_cast<std::uint32_t>(region.y);
  message.region_width = static_cast<std::uint32_t>(region.width);
  message.region_height = static_cast<std::uint32_t>(region.height);
  return message;
}

void set_region(const NumberedFrame& frame, sensor_msgs::CameraInfo& info) {
  const auto& image = frame.frame.image;
  info.roi.x_offset = image.first_column;
  info.roi.y_offset = image.first_row;
  info.roi.width = image.columns;
  info.roi.height = image.rows;
}

std::string find_fault(const scan_cell_common::ScannerModel& model,
                       const CameraDescription& camera) {
  if (model.camera.width == camera.sensor_columns && model.camera.height == camera.sensor_rows)
    return "";
  return fmt::format(
      "scanner_model: for a sensor of {} x {} pixels, this camera has {} x {}; load the model of "
      "this camera",
      model.camera.width, model.camera.height, camera.sensor_columns, camera.sensor_rows);
}

sensor_msgs::CameraInfo to_camera_info(const CameraDescription& camera,
                                       const scan_cell_common::ScannerModel* model,
                                       const std::string& frame_id) {
  sensor_msgs::CameraInfo info;
  info.header.frame_id = frame_id;
  info.width = camera.sensor_columns;
  info.height = camera.sensor_rows;
  info.roi.x_offset = camera.region.x;
  info.roi.y_offset = camera.region.y;
  info.roi.width = camera.region.width;
  info.roi.height = camera.region.height;
  if (!model || !find_fault(*model, camera).empty()) return info;
  const scan_cell_common::CameraIntrinsics& lens = model->camera;
  info.distortion_model = sensor_msgs::distortion_models::PLUMB_BOB;
  info.D.assign(lens.distortion.begin(), lens.distortion.end());
  info.K = {lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {lens.fx, 0, lens.cx, 0, 0, lens.fy, lens.cy, 0, 0, 0, 1, 0};
  return info;
}

}  // namespace tecnogamma_camera
