// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <vector>

#include "fake_cameras.h"
#include "tecnogamma_camera/acquisition.h"

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

namespace {

/// What the scripted cameras of a test share: the frames they will send, and what was done to them.
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
    if (settings.exposure) script_.exposure = *settings.exposure;
  }
  void set_exposure(double exposure) override {
    if (exposure > 1)
      throw scan_cell_common::InvalidParameter("exposure", "too long", "shorten it");
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

}  // namespace

TEST_F(AcquisitionOfScriptedCamera, DeliversNothingUntilItIsStarted) {
  Acquisition& acquisition = start();
  script_.send(1);
  EXPECT_TRUE(wait_until([&] { return acquisition.state().connected; }));
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::STOP);
  EXPECT_TRUE(recorder_.frames().empty());
  EXPECT_EQ(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL), 1U);
  expect_frames({{1, 1, 0}});
}

TEST_F(AcquisitionOfScriptedCamera, GivesEachStartANumber) {
  Acquisition& acquisition = start();
  EXPECT_EQ(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL), 1U);
  EXPECT_EQ(acquisition.set(AcquisitionMode::STOP, Trigger::EXTERNAL), 0U);
  EXPECT_EQ(acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::EXTERNAL), 2U);
  EXPECT_EQ(acquisition.set(AcquisitionMode::RELIEF_LIVE, Trigger::EXTERNAL), 3U);
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::RELIEF_LIVE);
}

TEST_F(AcquisitionOfScriptedCamera, AnswersAStartInFreeRunOnlyWithTheFirstFrame) {
  Acquisition& acquisition = start();
  EXPECT_THROW(acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::FREE_RUN), ConnectionError);
  script_.send(77);
  EXPECT_GT(acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::FREE_RUN), 0U);
  EXPECT_EQ(recorder_.frames().back().counter, 77U);
}

TEST_F(AcquisitionOfScriptedCamera, UnwrapsTheCounterAndCountsWhatIsMissing) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  for (const std::uint64_t raw : {65534, 65535, 0, 3, 3})
    script_.send(raw);
  script_.send(70000);
  script_.send(4);
  expect_frames(
      {{1, 65534, 0}, {1, 65535, 0}, {1, 65536, 0}, {1, 65539, 0}, {1, 65539, 0}, {1, 65540, 0}});
  const auto frames = acquisition.state().frames;
  EXPECT_EQ(frames.received, 7U);
  EXPECT_EQ(frames.lost, 2U);
  EXPECT_EQ(frames.repeated, 1U);
  EXPECT_EQ(frames.invalid, 1U);
}

TEST_F(AcquisitionOfScriptedCamera, TellsALateFrameFromARestartedCamera) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  script_.send(50, 5000);
  script_.send(49, 4900);  // late: its time is earlier
  script_.send(51, 5100);
  script_.send(1, 5200);  // restarted: its time goes on, and the next frame counts on from it
  script_.send(2, 5300);
  script_.send(3, 5400);
  expect_frames({{1, 50, 0}, {1, 49, 0}, {1, 51, 0}, {1, 1, 0}, {2, 2, 0}, {2, 3, 0}});
  EXPECT_EQ(acquisition.state().frames.late, 2U);
  EXPECT_EQ(acquisition.state().frames.restarts, 1U);
}

TEST_F(AcquisitionOfScriptedCamera, TakesACounterWithoutClockThatCountsOnFromLessForRestarted) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  for (const std::uint64_t raw : {50, 49, 51, 48, 52, 1, 2, 3, 4})
    script_.send(raw);
  // 49 and 48 are late; 1 and 2 could be, and only 3 shows that it was restarted.
  expect_frames({{1, 50, 0},
                 {1, 49, 0},
                 {1, 51, 0},
                 {1, 48, 0},
                 {1, 52, 0},
                 {1, 1, 0},
                 {1, 2, 0},
                 {2, 3, 0},
                 {2, 4, 0}});
  EXPECT_EQ(acquisition.state().frames.late, 4U);
  EXPECT_EQ(acquisition.state().frames.restarts, 1U);
}

TEST_F(AcquisitionOfScriptedCamera, TakesLateFramesBetweenOthersForLateHoweverMany) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  for (const std::uint64_t raw : {50, 40, 51, 41, 52, 42, 53})
    script_.send(raw);
  expect_frames(
      {{1, 50, 0}, {1, 40, 0}, {1, 51, 0}, {1, 41, 0}, {1, 52, 0}, {1, 42, 0}, {1, 53, 0}});
}

TEST_F(AcquisitionOfScriptedCamera, NoticesARestartAlsoWhereTheClockWasSetBackWithTheCounter) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  script_.send(500, 5000000);
  for (std::uint64_t raw = 1; raw <= 4; ++raw)
    script_.send(raw, static_cast<scan_cell_common::Nanoseconds>(1000 * raw));
  expect_frames({{1, 500, 0}, {1, 1, 0}, {1, 2, 0}, {2, 3, 0}, {2, 4, 0}});
}

TEST_F(AcquisitionOfScriptedCamera, BeginsANewAcquisitionWhereTheFrameSaysSo) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  Frame frame;
  frame.counter = 7;
  frame.device_time = 700;
  script_.send(frame);
  frame.restarted = true;
  script_.send(frame);
  frame.fault = "damaged";  // it may be the first of a turn that is
  script_.send(frame);
  script_.send(3);
  expect_frames({{1, 7, 0}, {2, 7, 0}, {3, 3, 0}});
  EXPECT_EQ(acquisition.state().frames.repeated, 0U);
  EXPECT_EQ(acquisition.state().frames.restarts, 2U);
}

TEST_F(AcquisitionOfScriptedCamera, TakesTheTimeThatWasRecordedAsItIs) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  Frame frame;
  frame.counter = 1;
  frame.device_time = 500;
  frame.host_time = 900000;
  frame.time = 123456789;
  script_.send(frame);
  expect_frames({{1, 1, 0}});
  EXPECT_EQ(recorder_.frames()[0].time, 123456789);
}

TEST_F(AcquisitionOfScriptedCamera, DropsAndCountsFramesWithAFaultAndTellsTheFirst) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  script_.send(1);
  Frame damaged;
  for (const char* fault : {"cut off after 3 bytes", "cut off after 4 bytes"}) {
    damaged.fault = fault;
    script_.send(damaged);
  }
  script_.send(4);
  expect_frames({{1, 1, 0}, {1, 4, 0}});
  const auto state = acquisition.state();
  EXPECT_EQ(state.frames.unusable, 2U);
  EXPECT_EQ(state.frames.lost, 2U) << "a gap in the counter";
  EXPECT_EQ(state.fault, "cut off after 4 bytes");
  ASSERT_EQ(recorder_.troubles().size(), 1U);
  EXPECT_NE(recorder_.troubles()[0].find("after 3 bytes"), std::string::npos);
  EXPECT_TRUE(state.connected);
}

TEST_F(AcquisitionOfScriptedCamera, RefusesAStartInFreeRunWhereNoFrameCanBeUsed) {
  parameters_.start_timeout = 0.2;
  Acquisition& acquisition = start();
  tecnogamma_camera::PeakProfile peaks;
  Frame relief;
  relief.counter = 1;
  relief.peaks = &peaks;
  script_.send(relief);
  try {
    acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::FREE_RUN);
    ADD_FAILURE() << "a camera that sends peaks alone has no live images";
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_NE(std::string(error.what()).find("no image"), std::string::npos) << error.what();
  }
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::STOP);
  EXPECT_TRUE(acquisition.state().connected);
  EXPECT_TRUE(recorder_.frames().empty());
  script_.send(relief);
  EXPECT_GT(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::FREE_RUN), 0U);
}

TEST_F(AcquisitionOfScriptedCamera, StopsWhereARecordingEndsAndSaysSo) {
  Acquisition& acquisition = start();
  script_.send(1);
  script_.end();
  EXPECT_EQ(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL), 1U);
  EXPECT_TRUE(wait_until([&] { return acquisition.state().mode == AcquisitionMode::STOP; }));
  expect_frames({{1, 1, 0}});
  EXPECT_NE(acquisition.state().message.find("ended"), std::string::npos);
  EXPECT_EQ(recorder_.endings, 1);
  EXPECT_TRUE(recorder_.troubles().empty()) << "that is no trouble";
  EXPECT_TRUE(acquisition.state().connected);
  EXPECT_EQ(acquisition.state().times_lost, 0U);
  lose_and_find();
  acquisition.set(AcquisitionMode::STOP, Trigger::EXTERNAL);
  EXPECT_EQ(acquisition.state().acquisition, 1U) << "what has ended is not resumed";
  script_.send(1);  // but can be played again
  EXPECT_EQ(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::FREE_RUN), 2U);
}

TEST_F(AcquisitionOfScriptedCamera, MapsTheCamerasClockToTheHosts) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  script_.send(1, 5000);
  script_.send(2, 6000);
  expect_frames({{1, 1, 0}, {1, 2, 0}});
  EXPECT_EQ(recorder_.frames()[1].time, 1000006000);
}

TEST_F(AcquisitionOfScriptedCamera, KeepsItsClockMapWhereAFrameComesLate) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  script_.send(1, 5000);
  script_.send(3, 7000, 0, 2000000);
  script_.send(2, 6000, 0, 9000000);  // overtaken by the one before
  script_.send(4, 8000, 0, 2000000);
  expect_frames({{1, 1, 0}, {1, 3, 0}, {1, 2, 0}, {1, 4, 0}});
  const auto frames = recorder_.frames();
  EXPECT_EQ(frames[2].time, 1000006000);
  EXPECT_EQ(frames[3].time, 1000008000);
}

TEST_F(AcquisitionOfScriptedCamera, ResumesAnExternalTriggerWithANewNumberAfterALoss) {
  Acquisition& acquisition = start();
  EXPECT_EQ(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL), 1U);
  lose_and_find();
  EXPECT_TRUE(wait_until([&] { return acquisition.state().mode == AcquisitionMode::RELIEF_ONLY; }));
  script_.send(9);
  expect_frames({{2, 9, 0}});
  EXPECT_EQ(acquisition.state().times_lost, 1U);
  EXPECT_EQ(acquisition.state().message, "");
}

TEST_F(AcquisitionOfScriptedCamera, StaysStoppedAfterALossInFreeRun) {
  Acquisition& acquisition = start();
  script_.send(1);
  acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::FREE_RUN);
  lose_and_find();
  EXPECT_TRUE(wait_until([&] { return acquisition.state().connected; }));
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::STOP);
  EXPECT_NE(acquisition.state().message, "");
  script_.send(2);
  EXPECT_EQ(acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::FREE_RUN), 2U);
  EXPECT_EQ(acquisition.state().message, "");
}

TEST_F(AcquisitionOfScriptedCamera, StopsWhatWasToBeResumedAlsoWhileTheCameraIsAway) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  script_.plug(false);
  EXPECT_TRUE(wait_until([&] { return !acquisition.state().connected; }));
  EXPECT_EQ(acquisition.set(AcquisitionMode::STOP, Trigger::EXTERNAL), 0U);
  script_.plug(true);
  EXPECT_TRUE(wait_until([&] { return acquisition.state().connected; }));
  EXPECT_EQ(acquisition.set(AcquisitionMode::STOP, Trigger::EXTERNAL), 0U);
  EXPECT_EQ(acquisition.state().acquisition, 1U);
}

TEST_F(AcquisitionOfScriptedCamera, LosesACameraThatFallsSilentInFreeRun) {
  parameters_.silence_timeout = 0.1;
  Acquisition& acquisition = start();
  script_.send(1);
  acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::FREE_RUN);
  EXPECT_TRUE(wait_until([&] { return acquisition.state().times_lost == 1; }));
}

TEST_F(AcquisitionOfScriptedCamera, SaysAReasonOnceHoweverOftenItTries) {
  script_.plugged_in = false;
  Acquisition& acquisition = start();
  EXPECT_THROW(acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::EXTERNAL), ConnectionError);
  EXPECT_EQ(recorder_.troubles().size(), 1U);
  EXPECT_EQ(acquisition.state().times_lost, 0U);
  EXPECT_NE(acquisition.state().message.find("unplugged"), std::string::npos);
}

TEST_F(AcquisitionOfScriptedCamera, StartsByItselfOnlyIfToldTo) {
  parameters_.mode = AcquisitionMode::RELIEF_ONLY;
  Acquisition& acquisition = start();
  EXPECT_TRUE(wait_until([&] { return acquisition.state().mode == AcquisitionMode::RELIEF_ONLY; }));
  EXPECT_EQ(acquisition.state().acquisition, 1U);
}

TEST_F(AcquisitionOfScriptedCamera, StaysConnectedWhereAStartIsRefused) {
  script_.refuse_start = true;
  Acquisition& acquisition = start();
  EXPECT_THROW(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL),
               tecnogamma_camera::MissingFeature);
  EXPECT_TRUE(acquisition.state().connected);
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::STOP);
}

TEST_F(AcquisitionOfScriptedCamera, ChangesTheRegionOnlyInStopAndTheExposureAlways) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  EXPECT_THROW(acquisition.set_region({0, 0, 64, 64}), scan_cell_common::Refused);
  acquisition.set_exposure(0.002);
  EXPECT_EQ(script_.exposure, 0.002);
  EXPECT_THROW(acquisition.set_exposure(2), scan_cell_common::InvalidParameter);
  acquisition.set(AcquisitionMode::STOP, Trigger::EXTERNAL);
  acquisition.set_region({0, 0, 64, 64});
  lose_and_find();
  acquisition.set(AcquisitionMode::STOP, Trigger::EXTERNAL);
  EXPECT_EQ(script_.exposure, 0.002);  // both hold for the camera that is found again
  EXPECT_EQ(script_.region.width, 64);
}
