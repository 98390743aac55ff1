// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <arv.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "camera/loopback.h"
#include "config_folder.h"
#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_sim/cell.h"

namespace scan_cell_sim {

using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;

inline constexpr const char* kAddress = "127.0.0.1";

inline bool wait_until(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

struct Received {
  std::uint64_t block = 0;
  Nanoseconds time = 0;
  Region region;
  std::vector<std::uint8_t> pixels;
};

/// A GigE Vision client as in a product: Aravis.
class Client {
 public:
  Client() {
    GError* error = nullptr;
    camera_ = arv_camera_new(kAddress, &error);
    g_clear_error(&error);
  }
  ~Client() {
    stop();
    g_clear_object(&camera_);
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  ArvCamera* get() const { return camera_; }
  bool connected() const { return camera_ != nullptr; }
  bool in_control() const {
    return arv_gv_device_is_controller(ARV_GV_DEVICE(arv_camera_get_device(camera_))) != 0;
  }

  void start(bool trigger) {
    constexpr int kPacketSize = 9000;
    constexpr int kBuffers = 50;
    if (trigger) {
      arv_camera_set_trigger(camera_, "Line0", nullptr);
    } else {
      arv_camera_clear_triggers(camera_, nullptr);
    }
    arv_camera_gv_set_packet_size(camera_, kPacketSize, nullptr);
    stream_ = arv_camera_create_stream(camera_, nullptr, nullptr, nullptr);
    ASSERT_NE(stream_, nullptr);
    const std::size_t payload = arv_camera_get_payload(camera_, nullptr);
    for (int i = 0; i < kBuffers; ++i)
      arv_stream_push_buffer(stream_, arv_buffer_new_allocate(payload));
    GError* error = nullptr;
    arv_camera_start_acquisition(camera_, &error);
    ASSERT_EQ(error, nullptr) << error->message;
  }

  void stop() {
    if (stream_ == nullptr) return;
    arv_camera_stop_acquisition(camera_, nullptr);
    g_clear_object(&stream_);
  }

  /// The next whole frame, or one without pixels if there is none in time. Broken ones are counted.
  Received next(double seconds = 20) {
    const Nanoseconds end = host_now() + scan_cell_common::from_seconds(seconds);
    while (host_now() < end) {
      constexpr guint64 kPatience = 20000;  // [us]
      ArvBuffer* const buffer = arv_stream_timeout_pop_buffer(stream_, kPatience);
      if (buffer == nullptr) continue;
      Received received = take(buffer);
      arv_stream_push_buffer(stream_, buffer);
      if (!received.pixels.empty()) return received;
      ++broken_;
    }
    return {};
  }

  int broken() const { return broken_; }

  /// Packets that were resent on request.
  std::uint64_t resent() const {
    guint64 resent = 0, missing = 0;
    arv_gv_stream_get_statistics(ARV_GV_STREAM(stream_), &resent, &missing);
    return resent;
  }

 private:
  static Received take(ArvBuffer* buffer) {
    if (arv_buffer_get_status(buffer) != ARV_BUFFER_STATUS_SUCCESS) return {};
    Received received;
    received.block = arv_buffer_get_frame_id(buffer);
    received.time = static_cast<Nanoseconds>(arv_buffer_get_timestamp(buffer));
    Region& r = received.region;
    arv_buffer_get_image_region(buffer, &r.x, &r.y, &r.width, &r.height);
    std::size_t size = 0;
    const auto* const data = static_cast<const std::uint8_t*>(arv_buffer_get_data(buffer, &size));
    received.pixels.assign(data, data + size);
    return received;
  }

  ArvCamera* camera_ = nullptr;
  ArvStream* stream_ = nullptr;
  int broken_ = 0;
};

inline CameraOptions camera_options() {
  CameraOptions options;
  options.genicam_file = kConfig + "/gige_camera.xml";
  return options;
}

/// Pixels that encode everything about the shot.
inline void draw_shot(const GigeCamera::Shot& shot, const Region& region, std::uint8_t* pixels) {
  const auto seed = static_cast<std::uint64_t>(shot.time) + shot.lasers + shot.frame;
  for (int i = 0; i < region.width * region.height; ++i) {
    pixels[i] =
        static_cast<std::uint8_t>((seed >> (i % 8 * 8)) + static_cast<std::uint64_t>(i) / 8);
  }
}

class CameraTest : public testing::Test {
 protected:
  /// Pulses until the camera takes one: its acquisition begins a little after the command.
  Nanoseconds first_pulse(std::uint8_t lasers) {
    Nanoseconds time = 0;
    EXPECT_TRUE(wait_until([&] {
      time = host_now();
      const std::uint64_t ignored = camera_.counts().ignored;
      camera_.pulse({time, lasers});
      return camera_.counts().ignored == ignored;
    }));
    return time;
  }

  GigeCamera camera_{camera_options(), draw_shot, [] { return std::uint8_t{2}; }};
};

}  // namespace scan_cell_sim
