// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include "frame/pixel_format.h"
#include "scan_cell_common/ros/parameter_reader.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::ParameterReader;

void read_optional(ParameterReader& reader, const std::string& name, std::optional<double>& value,
                   double unset, const ParameterReader::Range& range) {
  double number = unset;
  reader.read(name, number, range);
  if (number != unset) value = number;
}

void read_camera(ParameterReader& reader, CameraSettings& camera) {
  constexpr ParameterReader::Range kPixels{0, 65535};
  reader.read("region_x", camera.region.x, kPixels);
  reader.read("region_y", camera.region.y, kPixels);
  reader.read("region_width", camera.region.width, kPixels);
  reader.read("region_height", camera.region.height, kPixels);
  read_optional(reader, "exposure", camera.exposure, 0, {0, 10});
  read_optional(reader, "gain", camera.gain, -1, {-1, 1000});
  read_optional(reader, "rate", camera.rate, 0, {0, 100000});
  reader.read("trigger_source", camera.trigger_source);
  reader.read("strobe_line", camera.strobe_line);
  reader.read("strobe_source", camera.strobe_source);
  reader.read_choice("pixel_format", camera.pixel_format, pixel_format_names());
}

void read_detection(ParameterReader& reader, Parameters& parameters) {
  reader.read_choice("detector", parameters.detector, detector_names());
  std::string choice = choice_names().front();
  reader.read_choice("choice", choice, choice_names());
  parameters.detection.choice = to_choice(choice);
  reader.read("trigger_level", parameters.detection.trigger_level, {kAutomaticLevel, 65535});
  reader.read("permanence", parameters.detection.permanence, {1, 64});
  reader.read("window", parameters.detection.window, {0, 255});
  reader.read("most_width", parameters.detection.most_width, {0, 65535});
  reader.read("live_ratio", parameters.live_ratio, {1, 100000});
}

void read_stream(ParameterReader& reader, AravisOptions& stream) {
  reader.read("buffers", stream.buffers, {4, 1000});
  reader.read("packet_size", stream.packet_size, {0, 65535});
  reader.read("packet_socket", stream.packet_socket);
  reader.read("packet_resend", stream.packet_resend);
  reader.read("realtime", stream.realtime);
}

void read_recording(ParameterReader& reader, Parameters& parameters) {
  reader.read("bag_topic", parameters.bag_topic);
  reader.read("playback_speed", parameters.source.playback.speed, {0, 1000});
  reader.read("loop", parameters.source.playback.loop);
}

void read_payload(ParameterReader& reader, PayloadOptions& payload) {
  reader.read_choice("payload", payload.format, payload_names());
  reader.read("payload_tick", payload.tecnogamma.tick, {0, 1});
  reader.read("scan_first_row", payload.photonfocus.scan_first_row, {-1, 65535});
  reader.read("scan_rows", payload.photonfocus.scan_rows, {-1, 1024});
  reader.read("scan_with_image", payload.photonfocus.with_image);
  payload.tecnogamma.check();
  payload.photonfocus.check();
}

AcquisitionMode to_mode(const std::string& name) {
  if (name == "live_only") return AcquisitionMode::LIVE_ONLY;
  if (name == "relief_only") return AcquisitionMode::RELIEF_ONLY;
  return name == "relief_live" ? AcquisitionMode::RELIEF_LIVE : AcquisitionMode::STOP;
}

void read_acquisition(ParameterReader& reader, AcquisitionParameters& acquisition) {
  std::string mode = "stop";
  reader.read_choice("mode", mode, {"stop", "live_only", "relief_only", "relief_live"});
  acquisition.mode = to_mode(mode);
  std::string trigger = "external_trigger";
  reader.read_choice("trigger", trigger, {"free_run", "external_trigger"});
  acquisition.trigger = trigger == "free_run" ? Trigger::FREE_RUN : Trigger::EXTERNAL;
  std::string clock = "mapped";
  reader.read_choice("device_clock", clock, {"mapped", "host"});
  acquisition.clock.device_is_host = clock == "host";
  reader.read("retry_period", acquisition.retry_period, {0.1, 60});
  reader.read("start_timeout", acquisition.start_timeout, {0.1, 60});
  reader.read("arming_time", acquisition.arming_time, {0, 10});
  reader.read("silence_timeout", acquisition.silence_timeout, {0.1, 3600});
  reader.read("clock_window", acquisition.clock.window, {0.1, 3600});
}

}  // namespace

Parameters Parameters::load(const ros::NodeHandle& node) {
  Parameters parameters;
  ParameterReader reader(node);
  reader.read("camera", parameters.camera);
  reader.read("frame_id", parameters.frame_id);
  reader.read("scanner_model", parameters.scanner_model);
  read_detection(reader, parameters);
  read_stream(reader, parameters.source.stream);
  read_recording(reader, parameters);
  read_payload(reader, parameters.source.payload);
  read_camera(reader, parameters.acquisition.camera);
  read_acquisition(reader, parameters.acquisition);
  reader.refuse_unknown();
  return parameters;
}

}  // namespace tecnogamma_camera
