// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>

#include "camera/gige_client.h"

namespace scan_cell_sim {
namespace {

TEST_F(CameraTest, TellsItsSensorRegionAndFeatures) {
  const Client client;
  ASSERT_TRUE(client.connected());
  ArvCamera* const camera = client.get();
  EXPECT_STREQ(arv_camera_get_device_serial_number(camera, nullptr), "SIM001");
  EXPECT_STREQ(arv_camera_get_vendor_name(camera, nullptr), "ScanCell");
  int width = 0, height = 0, x = 0, y = 0;
  arv_camera_get_sensor_size(camera, &width, &height, nullptr);
  EXPECT_EQ(width, 1696);
  EXPECT_EQ(height, 1710);
  arv_camera_get_region(camera, &x, &y, &width, &height, nullptr);
  EXPECT_EQ(x, 336);
  EXPECT_EQ(y, 599);
  EXPECT_EQ(width, 1024);
  EXPECT_EQ(height, 512);
  EXPECT_EQ(arv_camera_get_integer(camera, "WidthMax", nullptr), 1696);
  EXPECT_EQ(arv_camera_get_integer(camera, "HeightMax", nullptr), 1710);
  EXPECT_NEAR(arv_camera_get_exposure_time(camera, nullptr), 1000, 1e-9);
  arv_camera_set_exposure_time(camera, 250, nullptr);
  EXPECT_NEAR(arv_camera_get_exposure_time(camera, nullptr), 250, 1e-9);
  double least = 0, most = 0;
  arv_camera_get_exposure_time_bounds(camera, &least, &most, nullptr);
  EXPECT_NEAR(least, 10, 1e-9);
  EXPECT_NEAR(most, 100000, 1e-9);
  EXPECT_EQ(arv_camera_get_payload(camera, nullptr), 1024U * 512U);
}

TEST_F(CameraTest, TakesARegionAndServesIt) {
  Client client;
  ASSERT_TRUE(client.connected());
  GError* error = nullptr;
  arv_camera_set_region(client.get(), 1000, 1600, 640, 100, &error);
  ASSERT_EQ(error, nullptr);
  arv_camera_set_frame_rate(client.get(), 50, &error);
  ASSERT_EQ(error, nullptr);
  EXPECT_NEAR(arv_camera_get_frame_rate(client.get(), nullptr), 50, 1e-6);
  client.start(false);
  const Received received = client.next();
  EXPECT_EQ(received.region.x, 1000);
  EXPECT_EQ(received.region.y, 1600);
  EXPECT_EQ(received.region.width, 640);
  EXPECT_EQ(received.region.height, 100);
  EXPECT_EQ(received.pixels.size(), 64000U);
}

TEST_F(CameraTest, AFrameIsWhatWasRenderedAtThePulse) {
  Client client;
  ASSERT_TRUE(client.connected());
  client.start(true);
  std::vector<std::pair<Nanoseconds, std::uint8_t>> pulses = {{first_pulse(1), 1}};
  for (const std::uint8_t lasers : {2, 0, 3, 1}) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    pulses.emplace_back(host_now(), lasers);
    camera_.pulse({pulses.back().first, lasers});
  }
  std::uint64_t frame = 0;
  for (const auto& [time, lasers] : pulses) {
    const Received received = client.next();
    ++frame;
    ASSERT_EQ(received.pixels.size(), 1024U * 512U);
    EXPECT_EQ(received.time, time);
    EXPECT_EQ(received.block, 65399 + frame);
    std::vector<std::uint8_t> truth(received.pixels.size());
    draw_shot({time, lasers, 0.001, 1, frame}, received.region, truth.data());
    EXPECT_EQ(received.pixels, truth);
  }
}

TEST_F(CameraTest, BlockIdsWrapToOne) {
  Client client;
  ASSERT_TRUE(client.connected());
  arv_camera_set_region(client.get(), 0, 0, 64, 8, nullptr);
  client.start(true);
  Nanoseconds time = first_pulse(1);
  std::uint64_t last = client.next().block;
  bool wrapped = false;
  for (int i = 0; i < 200; ++i) {
    camera_.pulse({time += 10'000'000, 1});
    const std::uint64_t block = client.next().block;
    ASSERT_EQ(block, last == 65535 ? 1 : last + 1);
    wrapped = wrapped || block < last;
    last = block;
  }
  EXPECT_TRUE(wrapped);
}

TEST_F(CameraTest, FreeRunShowsTheLasersThatAreOn) {
  Client client;
  ASSERT_TRUE(client.connected());
  client.start(false);
  const Nanoseconds before = host_now();
  const Received received = client.next();
  EXPECT_GE(received.time, before - 1'000'000'000);
  std::vector<std::uint8_t> truth(received.pixels.size());
  const auto frame = static_cast<std::uint64_t>(received.block - 65399);
  draw_shot({received.time, 2, 0.001, 1, frame}, received.region, truth.data());
  EXPECT_EQ(received.pixels, truth);
  camera_.pulse({host_now(), 1});
  EXPECT_EQ(camera_.counts().ignored, 1U);
}

TEST_F(CameraTest, PulsesTooSoonAreLostAndCounted) {
  Client client;
  ASSERT_TRUE(client.connected());
  client.start(true);
  const Nanoseconds time = first_pulse(1);
  camera_.pulse({time + 1'000'000, 1});
  camera_.pulse({time + 2'000'000, 1});
  EXPECT_EQ(camera_.counts().too_soon, 1U);
  EXPECT_EQ(client.next().time, time);
  EXPECT_EQ(client.next().time, time + 2'000'000);
}

TEST(CameraOnASlowWire, DrawsTheNextFrameWhileOneIsSent) {
  CameraOptions options = camera_options();
  options.wire_rate = 5e5;  // [bytes/s] a frame takes a second
  std::atomic<int> drawn{0};
  const auto draw = [&drawn](const GigeCamera::Shot& shot, const Region& region,
                             std::uint8_t* pixels) {
    draw_shot(shot, region, pixels);
    ++drawn;
  };
  GigeCamera camera(options, draw, [] { return std::uint8_t{2}; });
  Client client;
  ASSERT_TRUE(client.connected());
  client.start(true);
  ASSERT_TRUE(wait_until([&] {
    camera.pulse({host_now(), 1});
    return drawn >= 2;
  }));
  EXPECT_TRUE(client.next(0.1).pixels.empty()) << "the first was sent before the second was drawn";
  EXPECT_FALSE(client.next().pixels.empty());
}

TEST_F(CameraTest, FramesOfTheLastAcquisitionAreNotSentInTheNext) {
  Client client;
  ASSERT_TRUE(client.connected());
  client.start(true);
  Nanoseconds time = first_pulse(1);
  for (int i = 0; i < 150; ++i)
    camera_.pulse({time += 3'000'000, 1});
  client.stop();
  ASSERT_TRUE(wait_until([this] {
    const GigeCamera::Counts counts = camera_.counts();
    return counts.frames + counts.discarded + counts.ignored == counts.pulses;
  }));
  EXPECT_GT(camera_.counts().discarded, 0U);
  client.start(true);
  time = first_pulse(1);
  EXPECT_EQ(client.next().time, time);
}

TEST_F(CameraTest, ASoftwareTriggerIsAFrameNow) {
  Client client;
  ASSERT_TRUE(client.connected());
  client.start(true);
  arv_camera_set_trigger_source(client.get(), "Software", nullptr);
  const Nanoseconds before = host_now();
  arv_camera_software_trigger(client.get(), nullptr);
  const Received received = client.next();
  EXPECT_GE(received.time, before);
  camera_.pulse({host_now(), 1});
  EXPECT_EQ(camera_.counts().ignored, 1U);
}

}  // namespace
}  // namespace scan_cell_sim
