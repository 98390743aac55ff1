// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "frame_client.h"

#include <arv.h>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_demo {
namespace {

constexpr guint64 kPatience = 20000;  // [us] to wait for a frame

void fail(GError* error, const std::string& address) {
  const std::string text = error == nullptr ? "does not answer" : error->message;
  g_clear_error(&error);
  throw scan_cell_common::ConnectionError("camera at " + address, text,
                                          "see whether another program has it");
}

}  // namespace

FrameClient::FrameClient(const std::string& address) {
  constexpr int kPacketSize = 9000;  // [bytes]
  constexpr int kBuffers = 300;
  GError* error = nullptr;
  camera_ = arv_camera_new(address.c_str(), &error);
  if (camera_ == nullptr) fail(error, address);
  arv_camera_set_trigger(camera_, "Line0", nullptr);
  arv_camera_gv_set_packet_size(camera_, kPacketSize, nullptr);
  stream_ = arv_camera_create_stream(camera_, nullptr, nullptr, &error);
  if (stream_ == nullptr) fail(error, address);
  const std::size_t payload = arv_camera_get_payload(camera_, nullptr);
  for (int i = 0; i < kBuffers; ++i)
    arv_stream_push_buffer(stream_, arv_buffer_new_allocate(payload));
  arv_camera_start_acquisition(camera_, &error);
  if (error != nullptr) fail(error, address);
}

FrameClient::~FrameClient() {
  arv_camera_stop_acquisition(camera_, nullptr);
  g_clear_object(&stream_);
  g_clear_object(&camera_);
}

void FrameClient::wait_until_it_takes(const std::function<void()>& begin_pulses,
                                      const std::function<void()>& end_pulses) {
  begin_pulses();
  while (!next()) {
  }
  end_pulses();
  constexpr int kLooks = 20;
  for (int without = 0; without < kLooks; ++without)
    if (next()) without = 0;
}

std::optional<Received> FrameClient::next() {
  ArvBuffer* const buffer = arv_stream_timeout_pop_buffer(stream_, kPatience);
  if (buffer == nullptr) return std::nullopt;
  Received frame;
  frame.block = arv_buffer_get_frame_id(buffer);
  frame.time = static_cast<scan_cell_common::Nanoseconds>(arv_buffer_get_timestamp(buffer));
  if (arv_buffer_get_status(buffer) == ARV_BUFFER_STATUS_SUCCESS) {
    arv_buffer_get_image_region(buffer, &frame.x, &frame.y, &frame.width, &frame.height);
    std::size_t size = 0;
    const auto* const data = static_cast<const std::uint8_t*>(arv_buffer_get_data(buffer, &size));
    frame.pixels.assign(data, data + size);
  } else {
    frame.fault = "packets missing";
  }
  arv_stream_push_buffer(stream_, buffer);
  return frame;
}

}  // namespace scan_cell_demo
