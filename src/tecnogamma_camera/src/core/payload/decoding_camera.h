// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "frame/tick_clock.h"
#include "tecnogamma_camera/camera.h"
#include "tecnogamma_camera/payload_decoder.h"

namespace tecnogamma_camera {

/// A camera that finds the peaks itself: wraps a decoder and a camera whose frames are payloads.
/// Counter and time come from the payload. A payload that cannot be decoded becomes a frame with a
/// fault; one with missing packets becomes a frame without a number.
class DecodingCamera : public Camera {
 public:
  DecodingCamera(std::unique_ptr<Camera> camera, std::unique_ptr<PayloadDecoder> decoder);

  CameraDescription describe() override;
  void configure(const CameraSettings& settings) override { camera_->configure(settings); }
  void set_exposure(double exposure) override { camera_->set_exposure(exposure); }
  void start(Trigger trigger) override;
  void stop() override;
  std::optional<Frame> grab(std::chrono::microseconds timeout) override;
  void software_trigger() override { camera_->software_trigger(); }
  StreamStatistics statistics() override { return camera_->statistics(); }
  std::optional<std::int64_t> feature(const std::string& name) override {
    return camera_->feature(name);
  }
  void throw_if_lost() override { camera_->throw_if_lost(); }

 private:
  Frame take_raw();
  Frame take_decoded();

  std::unique_ptr<Camera> camera_;
  std::unique_ptr<PayloadDecoder> decoder_;
  TickClock clock_;
  Frame raw_;  // without its pixels: common to all frames decoded from it
  std::vector<DecodedFrame> decoded_;
  std::size_t count_ = 0;  // of decoded_ that are of the last payload
  std::size_t next_ = 0;
};

}  // namespace tecnogamma_camera
