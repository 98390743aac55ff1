// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "payload/decoding_camera.h"

#include <fmt/format.h>

namespace tecnogamma_camera {

DecodingCamera::DecodingCamera(std::unique_ptr<Camera> camera,
                               std::unique_ptr<PayloadDecoder> decoder)
    : camera_(std::move(camera)), decoder_(std::move(decoder)), clock_(decoder_->tick()) {}

CameraDescription DecodingCamera::describe() {
  CameraDescription description = camera_->describe();
  decoder_->describe(description);
  return description;
}

void DecodingCamera::start(Trigger trigger) {
  decoder_->adapt([this](const std::string& name) { return camera_->feature(name); });
  count_ = next_ = 0;
  raw_ = {};
  clock_.reset();
  camera_->start(trigger);
}

void DecodingCamera::stop() {
  count_ = next_ = 0;
  camera_->stop();
}

std::optional<Frame> DecodingCamera::grab(std::chrono::microseconds timeout) {
  if (next_ < count_) return take_decoded();
  std::optional<Frame> payload = camera_->grab(timeout);
  if (!payload) return std::nullopt;
  const GreyImage bytes = payload->image;
  if (payload->restarted) clock_.reset();
  payload->restarted |= raw_.restarted;  // reported by a payload without frames
  raw_ = std::move(*payload);
  raw_.counter = kNoFrameNumber;  // of the transport: the frames have their own
  raw_.image = {};
  if (!raw_.fault.empty() || raw_.packets_lost > 0) return take_raw();
  try {
    next_ = 0;
    count_ = 0;
    if (bytes.bytes_per_pixel() != 1) {
      throw scan_cell_common::UnusableInput("payload", fmt::format("{} bit pixels", bytes.bits),
                                            "payloads are bytes: give Mono8");
    }
    count_ = decoder_->decode(bytes.as<std::uint8_t>(), decoded_);
  } catch (const scan_cell_common::Error& error) {
    raw_.fault = error.what();
    return take_raw();
  }
  if (count_ == 0) return std::nullopt;
  return take_decoded();
}

/// Only the first of its frames reports a restart of the camera.
Frame DecodingCamera::take_raw() {
  Frame frame = raw_;
  raw_.restarted = false;
  return frame;
}

Frame DecodingCamera::take_decoded() {
  const DecodedFrame& decoded = decoded_[next_++];
  Frame frame = take_raw();
  frame.counter = decoded.counter;
  if (decoded.ticks) frame.device_time = clock_.unwrap(*decoded.ticks, frame.host_time);
  frame.packets_lost = decoded.packets_lost;
  frame.impossible_peaks = decoded.impossible_peaks;
  frame.image = decoded.image;
  if (decoded.has_peaks) frame.peaks = &decoded.peaks;
  return frame;
}

}  // namespace tecnogamma_camera
