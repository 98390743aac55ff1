// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <deque>

#include "payload/decoding_camera.h"
#include "payload/payloads.h"
#include "tecnogamma_camera/photonfocus_3d03.h"
#include "tecnogamma_camera/tecnogamma_relief.h"

using payloads::Photonfocus;
using payloads::Relief;
using tecnogamma_camera::CameraDescription;
using tecnogamma_camera::CameraSettings;
using tecnogamma_camera::DecodingCamera;
using tecnogamma_camera::Frame;
using tecnogamma_camera::kNoFrameNumber;
using tecnogamma_camera::Photonfocus3D03Decoder;
using tecnogamma_camera::Photonfocus3D03Settings;
using tecnogamma_camera::StreamStatistics;
using tecnogamma_camera::TecnogammaDecoder;
using tecnogamma_camera::TecnogammaSettings;
using tecnogamma_camera::Trigger;

namespace {

/// A camera that sends what it is given.
class PayloadCamera : public tecnogamma_camera::Camera {
 public:
  struct Sent {
    std::string bytes;
    int columns = 0;
    std::uint32_t packets_lost = 0;
    bool restarted = false;
  };
  explicit PayloadCamera(std::deque<Sent> sent) : sent_(std::move(sent)) {}

  CameraDescription describe() override {
    CameraDescription description;
    description.id = "payload camera";
    description.sensor_columns = description.sensor_rows = 4096;
    return description;
  }
  void configure(const CameraSettings&) override {}
  void set_exposure(double) override {}
  void start(Trigger) override {}
  void stop() override {}
  std::optional<Frame> grab(std::chrono::microseconds) override {
    if (sent_.empty()) return std::nullopt;
    now_ = sent_.front();
    sent_.pop_front();
    Frame frame;
    frame.counter = ++block_id_;
    frame.device_time = 77;
    frame.host_time = 1'000'000'000 + block_id_;
    frame.packets_lost = now_.packets_lost;
    frame.restarted = now_.restarted;
    if (now_.packets_lost == 0) frame.image = payloads::view(now_.bytes, now_.columns);
    return frame;
  }
  void software_trigger() override {}
  StreamStatistics statistics() override { return {}; }
  void throw_if_lost() override {}

 private:
  std::deque<Sent> sent_;
  Sent now_;
  std::int64_t block_id_ = 0;
};

std::string relief(std::uint16_t counter, std::uint32_t time, std::uint32_t packets_lost = 0) {
  Relief frame;
  frame.counter = counter;
  frame.time = time;
  frame.packets_lost = packets_lost;
  frame.spot(40, 5).spot(40, 5).spot(40, 5).spot(40, 5);
  return frame.bytes();
}

DecodingCamera tecnogamma(std::deque<PayloadCamera::Sent> sent, double tick = 1e-6) {
  TecnogammaSettings settings;
  settings.tick = tick;
  return {std::make_unique<PayloadCamera>(std::move(sent)),
          std::make_unique<TecnogammaDecoder>(settings)};
}

std::optional<Frame> grab(DecodingCamera& camera) {
  return camera.grab(std::chrono::microseconds(0));
}

}  // namespace

TEST(DecodingCamera, GivesNumberAndTimeOfThePayloadNotOfItsTransport) {
  auto camera = tecnogamma({{relief(500, 4000000)}, {relief(501, 4001000)}});
  camera.start(Trigger::kExternal);
  const auto first = grab(camera);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->counter, 500U);
  ASSERT_NE(first->peaks, nullptr);
  EXPECT_EQ(first->peaks->position[0], 64 + 42);
  const auto time = first->device_time;
  const auto second = grab(camera);
  EXPECT_EQ(second->counter, 501U);
  EXPECT_EQ(second->device_time - time, 1000000) << "1000 ticks of 1 us";
  EXPECT_FALSE(grab(camera));
  EXPECT_EQ(camera.describe().counter.last, 65535U);
  EXPECT_EQ(camera.describe().sensor_rows, 1710);
}

TEST(DecodingCamera, KeepsTheTransportsTimeWhereThePayloadsUnitIsNotKnown) {
  auto camera = tecnogamma({{relief(500, 4000000)}}, 0);
  camera.start(Trigger::kExternal);
  EXPECT_EQ(grab(camera)->device_time, 77);
}

TEST(DecodingCamera, MakesAFaultOfAPayloadThatCannotBeDecodedAndGoesOn) {
  auto camera = tecnogamma({{relief(1, 0).substr(0, 40)}, {relief(2, 0)}});
  camera.start(Trigger::kExternal);
  const auto damaged = grab(camera);
  ASSERT_TRUE(damaged);
  EXPECT_NE(damaged->fault.find("cut off"), std::string::npos) << damaged->fault;
  EXPECT_EQ(damaged->peaks, nullptr);
  EXPECT_EQ(damaged->image.pixels, nullptr);
  const auto next = grab(camera);
  EXPECT_EQ(next->fault, "");
  EXPECT_EQ(next->counter, 2U);
}

TEST(DecodingCamera, HasNoNumberWherePacketsOfTheTransportAreMissing) {
  auto camera = tecnogamma({{relief(1, 0), 0, 5}, {relief(2, 0, 3)}});
  camera.start(Trigger::kExternal);
  const auto torn = grab(camera);
  EXPECT_EQ(torn->counter, kNoFrameNumber);
  EXPECT_EQ(torn->packets_lost, 5U);
  EXPECT_EQ(torn->peaks, nullptr);
  const auto lost_before = grab(camera);  // on the way into the camera's own memory
  EXPECT_EQ(lost_before->counter, 2U);
  EXPECT_EQ(lost_before->packets_lost, 3U);
  EXPECT_EQ(lost_before->peaks, nullptr);
}

TEST(DecodingCamera, HandsOutCombinedFramesOneByOne) {
  Photonfocus sent(32, 3);
  for (int block = 0; block < 3; ++block) {
    sent.number(block, 0xFFFFFE + static_cast<unsigned>(block),
                100U * static_cast<unsigned>(block));
    sent.set(block, 0, 10 + block, 0, 4, 0);
  }
  Photonfocus fillers(32, 1);
  fillers.fill(0);
  Photonfocus3D03Settings settings;
  settings.scan_first_row = 0;
  DecodingCamera camera(std::make_unique<PayloadCamera>(
                            std::deque<PayloadCamera::Sent>{{sent.bytes, 32}, {fillers.bytes, 32}}),
                        std::make_unique<Photonfocus3D03Decoder>(settings));
  camera.start(Trigger::kExternal);
  constexpr std::uint64_t kCounters[] = {0xFFFFFE, 0xFFFFFF, 0};  // of 24 bits
  scan_cell_common::Nanoseconds time = 0;
  for (int block = 0; block < 3; ++block) {
    const auto frame = grab(camera);
    ASSERT_TRUE(frame) << block;
    EXPECT_EQ(frame->counter, kCounters[block]);
    EXPECT_EQ(frame->peaks->position[31], 4 * (10 + block));
    if (block > 0) {
      EXPECT_EQ(frame->device_time - time, 100000);
    }
    time = frame->device_time;
  }
  EXPECT_FALSE(grab(camera)) << "fillers are no frames";
}

TEST(DecodingCamera, TellsARestartWithTheFirstFrameAlsoAfterAPayloadWithoutFrames) {
  Photonfocus sent(32, 2);
  Photonfocus fillers(32, 1);
  fillers.fill(0);
  Photonfocus3D03Settings settings;
  settings.scan_first_row = 0;
  DecodingCamera camera(
      std::make_unique<PayloadCamera>(std::deque<PayloadCamera::Sent>{
          {sent.bytes, 32}, {fillers.bytes, 32, 0, true}, {sent.bytes, 32}, {sent.bytes, 33}}),
      std::make_unique<Photonfocus3D03Decoder>(settings));
  camera.start(Trigger::kExternal);
  EXPECT_FALSE(grab(camera)->restarted);
  EXPECT_FALSE(grab(camera)->restarted);
  EXPECT_FALSE(grab(camera)) << "fillers";
  EXPECT_TRUE(grab(camera)->restarted);
  EXPECT_FALSE(grab(camera)->restarted);
  EXPECT_FALSE(grab(camera)->restarted) << "told once, whatever comes next";
}

TEST(DecodingCamera, ForgetsWhatWasNotHandedOutWhenItIsStopped) {
  Photonfocus sent(32, 2);
  Photonfocus3D03Settings settings;
  settings.scan_first_row = 0;
  DecodingCamera camera(
      std::make_unique<PayloadCamera>(std::deque<PayloadCamera::Sent>{{sent.bytes, 32}}),
      std::make_unique<Photonfocus3D03Decoder>(settings));
  camera.start(Trigger::kExternal);
  EXPECT_TRUE(grab(camera));
  camera.stop();
  EXPECT_FALSE(grab(camera)) << "the second of the two";
  camera.start(Trigger::kExternal);
  EXPECT_FALSE(grab(camera));
}
