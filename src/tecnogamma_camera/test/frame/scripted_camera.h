// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "acquisition/acquisition.h"
#include "aravis/fake_cameras.h"

/// A scripted camera, and an acquisition from it.
namespace scripted {

using fake_cameras::wait_until;
using scan_cell_common::ConnectionError;
using tecnogamma_camera::Acquisition;
using tecnogamma_camera::AcquisitionListener;
using tecnogamma_camera::AcquisitionMode;
using tecnogamma_camera::AcquisitionParameters;
using tecnogamma_camera::Camera;
using tecnogamma_camera::CameraDescription;
using tecnogamma_camera::CameraSettings;
using tecnogamma_camera::Frame;
using tecnogamma_camera::NumberedFrame;
using tecnogamma_camera::StreamStatistics;
using tecnogamma_camera::Trigger;

/// Shared by the scripted cameras of a test: the frames that they will send, and what was done to
/// them.
struct Script {
  std::mutex mutex;
  std::deque<Frame> frames;
  bool plugged_in = true;
  bool running = false;
  bool refuse_start = false;
  double exposure = 0;
  tecnogamma_camera::Region region;
  int opened = 0;
  bool ended = false;  // the stream, once the frames are used up

  void send(std::uint64_t counter, scan_cell_common::Nanoseconds device_time = 0,
            std::uint32_t packets_lost = 0, scan_cell_common::Nanoseconds delay = 0) {
    const std::lock_guard<std::mutex> lock(mutex);
    Frame frame;
    frame.counter = counter;
    frame.device_time = device_time;
    frame.host_time = 1000000000 + device_time + delay;
    frame.packets_lost = packets_lost;
    frames.push_back(frame);
  }
  void send(const Frame& frame) {
    const std::lock_guard<std::mutex> lock(mutex);
    frames.push_back(frame);
  }
  void end() {
    const std::lock_guard<std::mutex> lock(mutex);
    ended = true;
  }
  void plug(bool in) {
    const std::lock_guard<std::mutex> lock(mutex);
    plugged_in = in;
  }
};

class ScriptedCamera : public Camera {
 public:
  explicit ScriptedCamera(Script& script) : script_(script) {
    throw_if_lost();
    const std::lock_guard<std::mutex> lock(script_.mutex);
    ++script_.opened;
  }
  ~ScriptedCamera() override { stop(); }
  CameraDescription describe() override {
    CameraDescription description;
    description.id = "scripted";
    description.counter = tecnogamma_camera::kCounter16;
    return description;
  }
  void configure(const CameraSettings& settings) override {
    const std::lock_guard<std::mutex> lock(script_.mutex);
    EXPECT_FALSE(script_.running) << "parameters are written only in STOP";
    script_.region = settings.region;
    refuse_long(settings.exposure.value_or(0));
    if (settings.exposure) script_.exposure = *settings.exposure;
  }
  void set_exposure(double exposure) override {
    refuse_long(exposure);
    const std::lock_guard<std::mutex> lock(script_.mutex);
    script_.exposure = exposure;
  }
  void start(Trigger) override {
    const std::lock_guard<std::mutex> lock(script_.mutex);
    if (script_.refuse_start)
      throw tecnogamma_camera::MissingFeature("camera feature", "TriggerSource", "none");
    script_.running = true;
  }
  void stop() override {
    const std::lock_guard<std::mutex> lock(script_.mutex);
    script_.running = false;
  }
  std::optional<Frame> grab(std::chrono::microseconds) override {
    throw_if_lost();
    {
      const std::lock_guard<std::mutex> lock(script_.mutex);
      if (!script_.frames.empty()) {
        const Frame frame = script_.frames.front();
        script_.frames.pop_front();
        return frame;
      }
      if (script_.ended) throw tecnogamma_camera::StreamEnded("recording", "ended", "loop");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::nullopt;
  }
  void software_trigger() override {}
  StreamStatistics statistics() override { return {}; }
  void throw_if_lost() override {
    const std::lock_guard<std::mutex> lock(script_.mutex);
    if (!script_.plugged_in) throw ConnectionError("camera", "unplugged", "plug it in");
  }

 private:
  static void refuse_long(double exposure) {
    if (exposure > 1)
      throw scan_cell_common::InvalidParameter("exposure", "too long", "shorten it");
  }
  Script& script_;
};

struct Received {
  std::uint32_t acquisition;
  std::uint64_t counter;
  scan_cell_common::Nanoseconds time;
  bool operator==(const Received& other) const {
    return acquisition == other.acquisition && counter == other.counter;
  }
};

class Recorder : public AcquisitionListener {
 public:
  void on_frame(const NumberedFrame& frame) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    frames_.push_back({frame.acquisition, frame.counter, frame.time});
  }
  void on_connected(const CameraDescription&) override { ++connections; }
  void on_ended(const std::string&) override { ++endings; }
  void on_trouble(const std::string& reason) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    troubles_.push_back(reason);
  }
  std::vector<Received> frames() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return frames_;
  }
  std::vector<std::string> troubles() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return troubles_;
  }
  std::atomic<int> connections{0};
  std::atomic<int> endings{0};

 private:
  std::mutex mutex_;
  std::vector<Received> frames_;
  std::vector<std::string> troubles_;
};

class AcquisitionOfScriptedCamera : public testing::Test {
 protected:
  AcquisitionOfScriptedCamera() {
    parameters_.retry_period = 0.01;
    parameters_.arming_time = 0.01;
    parameters_.start_timeout = 1.0;
    parameters_.silence_timeout = 1000;
  }

  Acquisition& start() {
    acquisition_ = std::make_unique<Acquisition>(
        parameters_, [this] { return std::make_unique<ScriptedCamera>(script_); }, recorder_);
    return *acquisition_;
  }
  void expect_frames(const std::vector<Received>& expected) {
    EXPECT_TRUE(wait_until([&] { return recorder_.frames().size() >= expected.size(); }));
    EXPECT_EQ(recorder_.frames(), expected);
  }
  void lose_and_find() {
    const int connections = recorder_.connections;
    script_.plug(false);
    EXPECT_TRUE(wait_until([&] { return !acquisition_->state().connected; }));
    script_.plug(true);
    EXPECT_TRUE(wait_until([&] { return recorder_.connections > connections; }));
  }

  AcquisitionParameters parameters_;
  Script script_;
  Recorder recorder_;
  std::unique_ptr<Acquisition> acquisition_;
};

}  // namespace scripted
