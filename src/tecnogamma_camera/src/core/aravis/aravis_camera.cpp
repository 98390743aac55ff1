// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "aravis/aravis_camera.h"

#include <algorithm>
#include <atomic>

#include "aravis/aravis_settings.h"
#include "aravis/aravis_support.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::ConnectionError;
using scan_cell_common::Refused;

/// [bytes] at the end of a row, from the frame's header.
std::size_t padding_of(ArvBuffer* buffer) {
  int padding = 0, rows_of_padding = 0;
  arv_buffer_get_image_padding(buffer, &padding, &rows_of_padding);
  return static_cast<std::size_t>(std::max(0, padding));
}

/// Gives a buffer to the stream, cleared of its last frame: Aravis leaves number and times as they
/// are if the first packet of a frame is lost.
void push_clean(ArvStream* stream, ArvBuffer* buffer) {
  arv_buffer_set_frame_id(buffer, kNoFrameNumber);
  arv_buffer_set_timestamp(buffer, 0);
  arv_buffer_set_system_timestamp(buffer, 0);
  arv_stream_push_buffer(stream, buffer);
}

class AravisCamera : public Camera {
 public:
  AravisCamera(ArvCameraPtr camera, const AravisOptions& options);
  ~AravisCamera() override;

  CameraDescription describe() override;
  void configure(const CameraSettings& settings) override;
  void set_exposure(double exposure) override;
  void start(Trigger trigger) override;
  void stop() override;
  std::optional<Frame> grab(std::chrono::microseconds timeout) override;
  void software_trigger() override;
  std::optional<std::int64_t> feature(const std::string& name) override;
  StreamStatistics statistics() override;
  void throw_if_lost() override;

 private:
  static void on_control_lost(ArvDevice* device, gpointer self);
  static void on_stream_event(void* self, ArvStreamCallbackType type, ArvBuffer* buffer);

  void refuse_while_running(const std::string& what) const;
  void create_stream();
  void release_frame();
  Frame to_frame(ArvBuffer* buffer);
  bool is_whole(ArvBuffer* buffer) const;
  void set_pixels(ArvBuffer* buffer, GreyImage& image);
  std::uint32_t packets_lost_since_last_frame();
  CounterRule counter_rule();

  AravisOptions options_;
  ArvCameraPtr camera_;
  ArvStreamPtr stream_;
  ArvBuffer* grabbed_ = nullptr;
  PixelFormat format_;
  std::vector<std::uint16_t> unpacked_;  // pixels of the last frame, where they came packed
  Region region_;
  CameraSettings settings_;
  std::unique_ptr<StrobeOutputs> strobes_;
  std::uint64_t missing_packets_ = 0;
  StreamStatistics last_statistics_;
  gulong control_lost_handler_ = 0;
  std::atomic<bool> lost_{false};
};

AravisCamera::AravisCamera(ArvCameraPtr camera, const AravisOptions& options)
    : options_(options), camera_(std::move(camera)) {
  ArvCamera* const arv = camera_.get();
  format_ = write_pixel_format(arv, CameraSettings().pixel_format);
  aravis("AcquisitionMode Continuous", [&](GError** e) {
    arv_camera_set_acquisition_mode(arv, ARV_ACQUISITION_MODE_CONTINUOUS, e);
  });
  if (arv_camera_is_binning_available(arv, nullptr)) {
    aravis("binning", [&](GError** e) { arv_camera_set_binning(arv, 1, 1, e); });
  }
  region_ = read_region(arv);
  control_lost_handler_ = g_signal_connect(arv_camera_get_device(arv), "control-lost",
                                           G_CALLBACK(&AravisCamera::on_control_lost), this);
}

AravisCamera::~AravisCamera() {
  stop();
  g_signal_handler_disconnect(arv_camera_get_device(camera_.get()), control_lost_handler_);
}

void AravisCamera::on_control_lost(ArvDevice*, gpointer self) {
  static_cast<AravisCamera*>(self)->lost_ = true;
}

void AravisCamera::on_stream_event(void* self, ArvStreamCallbackType type, ArvBuffer*) {
  if (type != ARV_STREAM_CALLBACK_TYPE_INIT) return;
  if (!static_cast<AravisCamera*>(self)->options_.realtime) return;
  constexpr int kPriority = 10;  // real-time; chosen
  constexpr int kNice = -10;     // without the right to that; chosen
  if (!arv_make_thread_realtime(kPriority)) arv_make_thread_high_priority(kNice);
}

void AravisCamera::throw_if_lost() {
  if (!lost_) return;
  throw ConnectionError("camera", "connection lost", "check its cable and power");
}

void AravisCamera::refuse_while_running(const std::string& what) const {
  if (!stream_) return;
  throw Refused(what, "the camera is running", "stop it first");
}

CounterRule AravisCamera::counter_rule() {
  ArvCamera* const arv = camera_.get();
  if (!arv_camera_is_gv_device(arv)) return kCounter64;
  constexpr const char* kExtended = "GevGVSPExtendedIDMode";
  if (!has_feature(arv, kExtended)) return kGigEVisionBlockId;
  const std::string mode = to_text(
      aravis(kExtended, [&](GError** e) { return arv_camera_get_string(arv, kExtended, e); }));
  return mode == "On" ? kCounter64 : kGigEVisionBlockId;
}

CameraDescription AravisCamera::describe() {
  throw_if_lost();
  ArvCamera* const arv = camera_.get();
  CameraDescription result;
  const auto text = [&](const char* what, const auto& get) {
    return to_text(aravis(what, [&](GError** e) { return get(arv, e); }));
  };
  result.vendor = text("vendor name", arv_camera_get_vendor_name);
  result.model = text("model name", arv_camera_get_model_name);
  result.serial = text("serial number", arv_camera_get_device_serial_number);
  result.id = result.vendor + "-" + result.model + "-" + result.serial;
  result.transport = arv_camera_is_gv_device(arv)   ? "GigE Vision"
                     : arv_camera_is_uv_device(arv) ? "USB3 Vision"
                                                    : "other";
  aravis("sensor size", [&](GError** e) {
    arv_camera_get_sensor_size(arv, &result.sensor_columns, &result.sensor_rows, e);
  });
  result.region = region_;
  result.grey_bits = format_.bits;
  if (arv_camera_is_exposure_time_available(arv, nullptr)) {
    result.exposure =
        aravis("exposure", [&](GError** e) { return arv_camera_get_exposure_time(arv, e); }) /
        kMicroseconds;
  }
  if (arv_camera_is_gv_device(arv)) {
    result.packet_size = static_cast<int>(
        aravis("packet size", [&](GError** e) { return arv_camera_gv_get_packet_size(arv, e); }));
  }
  result.counter = counter_rule();
  result.lines = words_of(arv, "LineSelector");
  result.trigger_sources = words_of(arv, "TriggerSource");
  return result;
}

void AravisCamera::configure(const CameraSettings& settings) {
  throw_if_lost();
  refuse_while_running("camera settings");
  if (options_.is_payload && settings.pixel_format != CameraSettings().pixel_format) {
    throw scan_cell_common::InvalidParameter("pixel_format", settings.pixel_format,
                                             "payloads are bytes: give Mono8");
  }
  format_ = write_pixel_format(camera_.get(), settings.pixel_format);
  region_ = options_.is_payload ? write_payload_region(camera_.get(), settings.region)
                                : write_region(camera_.get(), settings.region);
  if (settings.exposure) write_exposure(camera_.get(), *settings.exposure);
  if (settings.gain) write_gain(camera_.get(), *settings.gain);
  if (settings.rate) write_rate(camera_.get(), *settings.rate);
  settings_ = settings;
}

void AravisCamera::set_exposure(double exposure) {
  throw_if_lost();
  write_exposure(camera_.get(), exposure);
}

void AravisCamera::create_stream() {
  ArvCamera* const arv = camera_.get();
  if (arv_camera_is_gv_device(arv)) {
    arv_camera_gv_set_stream_options(arv, options_.packet_socket
                                              ? ARV_GV_STREAM_OPTION_NONE
                                              : ARV_GV_STREAM_OPTION_PACKET_SOCKET_DISABLED);
    if (options_.packet_size > 0) {
      aravis("packet size",
             [&](GError** e) { arv_camera_gv_set_packet_size(arv, options_.packet_size, e); });
    } else {
      aravis("packet size", [&](GError** e) { arv_camera_gv_auto_packet_size(arv, e); });
    }
  }
  stream_.reset(aravis("stream", [&](GError** e) {
    return arv_camera_create_stream(arv, &AravisCamera::on_stream_event, this, e);
  }));
  if (ARV_IS_GV_STREAM(stream_.get())) {
    g_object_set(stream_.get(), "socket-buffer", ARV_GV_STREAM_SOCKET_BUFFER_AUTO, "packet-resend",
                 options_.packet_resend ? ARV_GV_STREAM_PACKET_RESEND_ALWAYS
                                        : ARV_GV_STREAM_PACKET_RESEND_NEVER,
                 nullptr);
  }
  const auto payload =
      aravis("PayloadSize", [&](GError** e) { return arv_camera_get_payload(arv, e); });
  for (int i = 0; i < options_.buffers; ++i)
    push_clean(stream_.get(), arv_buffer_new_allocate(payload));
}

void AravisCamera::start(Trigger trigger) {
  throw_if_lost();
  refuse_while_running("camera start");
  try {
    if (!settings_.strobe_line.empty()) {
      strobes_ = std::make_unique<StrobeOutputs>(camera_.get(), settings_.strobe_line,
                                                 settings_.strobe_source);
    }
    write_trigger(camera_.get(), trigger, settings_.trigger_source);
    // An external trigger switched the rate off.
    if (trigger == Trigger::kFreeRun && settings_.rate) write_rate(camera_.get(), *settings_.rate);
    if (options_.is_payload) region_ = write_payload_region(camera_.get(), settings_.region);
    create_stream();
    aravis("AcquisitionStart", [&](GError** e) { arv_camera_start_acquisition(camera_.get(), e); });
  } catch (...) {
    stream_.reset();
    strobes_.reset();
    throw;
  }
  missing_packets_ = 0;
}

void AravisCamera::stop() {
  if (!stream_) return;
  release_frame();
  // A lost camera does not answer: each call would only wait seconds for its time-out.
  if (!lost_) arv_camera_stop_acquisition(camera_.get(), nullptr);
  last_statistics_ = statistics();
  stream_.reset();
  if (lost_ && strobes_) strobes_->forget();
  strobes_.reset();
}

void AravisCamera::release_frame() {
  if (grabbed_) push_clean(stream_.get(), grabbed_);
  grabbed_ = nullptr;
}

std::optional<Frame> AravisCamera::grab(std::chrono::microseconds timeout) {
  if (!stream_) throw Refused("camera grab", "the camera is stopped", "start it first");
  release_frame();
  throw_if_lost();
  grabbed_ = arv_stream_timeout_pop_buffer(stream_.get(), timeout.count());
  if (!grabbed_) return std::nullopt;
  if (arv_buffer_get_status(grabbed_) == ARV_BUFFER_STATUS_ABORTED) return std::nullopt;
  return to_frame(grabbed_);
}

std::uint32_t AravisCamera::packets_lost_since_last_frame() {
  const std::uint64_t now = statistics().missing_packets;
  const std::uint64_t lost = now - missing_packets_;
  missing_packets_ = now;
  return static_cast<std::uint32_t>(lost);
}

Frame AravisCamera::to_frame(ArvBuffer* buffer) {
  Frame frame;
  frame.counter = arv_buffer_get_frame_id(buffer);
  frame.device_time = static_cast<Nanoseconds>(arv_buffer_get_timestamp(buffer));
  frame.host_time = static_cast<Nanoseconds>(arv_buffer_get_system_timestamp(buffer));
  constexpr Nanoseconds kMicrosecond = 1000;  // [ns]
  if (frame.host_time == 0) frame.host_time = g_get_real_time() * kMicrosecond;
  frame.image.columns = region_.width;
  frame.image.rows = region_.height;
  frame.image.first_column = region_.x;
  frame.image.first_row = region_.y;
  frame.image.bits = format_.bits;
  if (is_whole(buffer)) {
    set_pixels(buffer, frame.image);
  } else {
    frame.packets_lost = std::max(1U, packets_lost_since_last_frame());
  }
  return frame;
}

bool AravisCamera::is_whole(ArvBuffer* buffer) const {
  if (arv_buffer_get_status(buffer) != ARV_BUFFER_STATUS_SUCCESS) return false;
  std::size_t size = 0;
  arv_buffer_get_image_data(buffer, &size);
  const auto needed = format_.bytes(static_cast<std::size_t>(region_.width),
                                    static_cast<std::size_t>(region_.height), padding_of(buffer));
  return arv_buffer_get_image_width(buffer) == region_.width &&
         arv_buffer_get_image_height(buffer) == region_.height &&
         arv_buffer_get_image_pixel_format(buffer) == format_.code && needed && size >= *needed;
}

/// Packed pixels continue across the ends of the rows.
void AravisCamera::set_pixels(ArvBuffer* buffer, GreyImage& image) {
  std::size_t size = 0;
  const void* const data = arv_buffer_get_image_data(buffer, &size);
  image.pixels = data;
  image.stride = region_.width;
  if (format_.packing == Packing::kBytes) {
    image.stride += static_cast<std::ptrdiff_t>(padding_of(buffer)) / image.bytes_per_pixel();
    return;
  }
  unpacked_.resize(static_cast<std::size_t>(region_.width) *
                   static_cast<std::size_t>(region_.height));
  unpack(format_, static_cast<const std::uint8_t*>(data), unpacked_);
  image.pixels = unpacked_.data();
}

void AravisCamera::software_trigger() {
  throw_if_lost();
  aravis("TriggerSoftware", [&](GError** e) { arv_camera_software_trigger(camera_.get(), e); });
}

std::optional<std::int64_t> AravisCamera::feature(const std::string& name) {
  throw_if_lost();
  if (!has_feature(camera_.get(), name.c_str())) return std::nullopt;
  return aravis(name,
                [&](GError** e) { return arv_camera_get_integer(camera_.get(), name.c_str(), e); });
}

StreamStatistics AravisCamera::statistics() {
  if (!stream_) return last_statistics_;
  StreamStatistics result;
  arv_stream_get_statistics(stream_.get(), &result.completed, &result.failures, &result.underruns);
  if (ARV_IS_GV_STREAM(stream_.get())) {
    arv_gv_stream_get_statistics(ARV_GV_STREAM(stream_.get()), &result.resent_packets,
                                 &result.missing_packets);
  }
  return result;
}

bool is_ip_address(const std::string& name) {
  return g_hostname_is_ip_address(name.c_str());
}

}  // namespace

std::unique_ptr<Camera> open_aravis_camera(const std::string& name, const AravisOptions& options) {
  // An address is contacted directly: that is faster, and works without broadcasts.
  const std::string id = is_ip_address(name) ? name : find_aravis_camera(name);
  ArvCameraPtr camera(
      aravis("camera '" + name + "'", [&](GError** e) { return arv_camera_new(id.c_str(), e); }));
  ArvDevice* const device = arv_camera_get_device(camera.get());
  if (ARV_IS_GV_DEVICE(device) && !arv_gv_device_is_controller(ARV_GV_DEVICE(device))) {
    throw ConnectionError("camera '" + name + "'", "another program holds it",
                          "end that program, or wait until the camera times out its connection");
  }
  return std::make_unique<AravisCamera>(std::move(camera), options);
}

}  // namespace tecnogamma_camera
