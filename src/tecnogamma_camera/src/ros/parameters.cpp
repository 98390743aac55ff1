// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include "frame/pixel_format.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::ParameterTable;

/// Describes a number that is left to the camera if it is `unset`.
void describe_optional(ParameterTable& table, const std::string& name, std::optional<double>& value,
                       double unset, const ParameterTable::Range& range,
                       const std::string& meaning) {
  double number = value.value_or(unset);
  table.add(name, number, range, meaning);
  if (number != unset) value = number;
}

void describe_camera(ParameterTable& table, CameraSettings& camera) {
  const ParameterTable::Range pixels{0, 65535, "px"};
  table.add("region_x", camera.region.x, pixels, "first sensor column that is read out");
  table.add("region_y", camera.region.y, pixels, "first sensor row that is read out");
  table.add("region_width", camera.region.width, pixels, "0: to the sensor's right edge");
  table.add("region_height", camera.region.height, pixels, "0: to the sensor's lower edge");
  describe_optional(table, "exposure", camera.exposure, 0, {0, 10, "s"},
                    "0: as the camera is set; 0 is refused once a value has been given");
  describe_optional(table, "gain", camera.gain, -1, {-1, 1000},
                    "in the camera's unit, mostly dB; -1: as the camera is set");
  describe_optional(table, "rate", camera.rate, 0, {0, 100000, "Hz"},
                    "of free run; 0: as the camera is set");
  table.add("trigger_source", camera.trigger_source,
            "GenICam TriggerSource of the external trigger (`Software` on Aravis' fake camera)");
  table.add(
      "strobe_line", camera.strobe_line,
      "GenICam LineSelector of the outputs to drive while the camera runs, such as `Line1` or "
      "`Line1, Line2`; none: no line is touched");
  table.add("strobe_source", camera.strobe_source, "GenICam LineSource of these outputs");
  table.choice("pixel_format", camera.pixel_format, pixel_format_names(),
               "GenICam PixelFormat; packed ones are unpacked on the host");
}

void describe_stream(ParameterTable& table, AravisOptions& stream) {
  table.add("buffers", stream.buffers, {4, 1000},
            "frames that may wait; too few show as `stream underruns`");
  table.add("packet_size", stream.packet_size, {0, 65535, "bytes"},
            "0: the largest that comes through");
  table.add("packet_socket", stream.packet_socket,
            "receive below the IP stack if the rights allow it");
  table.add("packet_resend", stream.packet_resend, "ask for missing packets");
  table.add("realtime", stream.realtime, "real-time receiving thread if the rights allow it");
}

void describe_recording(ParameterTable& table, Parameters& parameters) {
  table.add("bag_topic", parameters.bag_topic, "topic of the images in a bag; none: the only one");
  table.add("playback_speed", parameters.source.playback.speed, {0, 1000},
            "of a recording, as a multiple of the recorded speed; 0: as fast as possible");
  table.add("loop", parameters.source.playback.loop,
            "play a recording again from its beginning when it ends");
}

void describe_payload(ParameterTable& table, PayloadOptions& payload) {
  table.choice("payload", payload.format, payload_names(), "what the frames hold (below)");
  table.add("payload_tick", payload.tecnogamma.tick, {0, 1, "s"},
            "of the time counter in relief frames; 0: not known, so the transport's time is used");
  table.add("scan_first_row", payload.photonfocus.scan_first_row, {-1, 65535, "px"},
            "Peak0_3DY of a 3D03; -1: read from the camera");
  table.add("scan_rows", payload.photonfocus.scan_rows, {-1, 1024, "px"},
            "Peak0_3DH of a 3D03; -1: read from the camera");
  table.add("scan_with_image", payload.photonfocus.with_image,
            "the 3D03 is in its mode 2D&3D, not in 3Donly");
  payload.tecnogamma.check();
  payload.photonfocus.check();
}

void describe_acquisition(ParameterTable& table, AcquisitionParameters& acquisition) {
  table.choice("mode", acquisition.mode, {"stop", "live_only", "relief_only", "relief_live"},
               "mode once the camera is first found");
  table.choice("trigger", acquisition.trigger, {"free_run", "external_trigger"},
               "trigger in that mode");
  std::string clock = acquisition.clock.device_is_host ? "host" : "mapped";
  table.choice(
      "device_clock", clock, {"mapped", "host"},
      "host: the camera's clock is the host's (PTP, a camera on this computer) and is "
      "taken as it is; more than 1 s between them is an error, unless a busy host explains it");
  acquisition.clock.device_is_host = clock == "host";
  table.add("clock_window", acquisition.clock.window, {0.1, 3600, "s"},
            "period over which the least delay is determined");
  table.add("retry_period", acquisition.retry_period, {0.1, 60, "s"},
            "between tries to find the camera; it does not grow");
  table.add("start_timeout", acquisition.start_timeout, {0.1, 60, "s"},
            "for the camera to be found, and for the first frame of free run");
  table.add("arming_time", acquisition.arming_time, {0, 10, "s"},
            "time after a start in which a camera may miss pulses");
  table.add("silence_timeout", acquisition.silence_timeout, {0.1, 3600, "s"},
            "the camera counts as lost after this long without a frame in free run");
}

}  // namespace

void describe(ParameterTable& table, Parameters& parameters) {
  table.add("camera", parameters.camera,
            "id, serial number or address (an IP address is contacted directly, without a search); "
            "`folder:PATH` or `bag:PATH`: a recording; none: the only camera that answers");
  table.add("frame_id", parameters.frame_id, "of images and profiles");
  table.add("scanner_model", parameters.scanner_model,
            "file for `camera_info` (scanner_model.md); none: uncalibrated");
  table.choice("detector", parameters.tuning.detector, detector_names(),
               "method that finds the laser's line");
  describe(table, parameters.tuning.detection);
  table.add("live_ratio", parameters.tuning.live_ratio, {1, kMaxLiveRatio},
            "profiles per image in RELIEF_LIVE");
  describe_acquisition(table, parameters.acquisition);
  describe_camera(table, parameters.acquisition.camera);
  describe_payload(table, parameters.source.payload);
  describe_recording(table, parameters);
  describe_stream(table, parameters.source.stream);
}

}  // namespace tecnogamma_camera
