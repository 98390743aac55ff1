// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <random>

#include "camera/gige_client.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_cell_sim {
namespace {

constexpr std::uint16_t kControlPort = 3956;  // of GigE Vision

TEST_F(CameraTest, LostFramesLeaveAGapInTheBlockIds) {
  Client client;
  ASSERT_TRUE(client.connected());
  arv_camera_set_region(client.get(), 0, 0, 64, 8, nullptr);
  client.start(true);
  Nanoseconds time = first_pulse(1);
  const std::uint64_t first = client.next().block;
  CameraFaults faults;
  faults.lost_frames = 1;
  camera_.set_faults(faults);
  camera_.pulse({time += 10'000'000, 1});
  camera_.set_faults({});
  camera_.pulse({time += 10'000'000, 1});
  EXPECT_EQ(client.next().block, first + 2);
  EXPECT_EQ(camera_.counts().lost_on_purpose, 1U);
}

TEST_F(CameraTest, LostPacketsBreakFrames) {
  Client client;
  ASSERT_TRUE(client.connected());
  CameraFaults faults;
  faults.lost_packets = 0.05;
  camera_.set_faults(faults);
  client.start(false);
  EXPECT_TRUE(wait_until([&] {
    client.next(0.1);
    return client.broken() > 0;
  }));
}

TEST_F(CameraTest, PacketsLostOnceComeWhenTheyAreAskedForAgain) {
  Client client;
  ASSERT_TRUE(client.connected());
  CameraFaults faults;
  faults.packets_lost_once = 0.03;
  camera_.set_faults(faults);
  client.start(true);
  Nanoseconds time = first_pulse(1);
  constexpr int kFrames = 30;
  for (int i = 1; i < kFrames; ++i)
    camera_.pulse({time += 10'000'000, 1});
  for (int i = 0; i < kFrames; ++i)
    ASSERT_FALSE(client.next().pixels.empty());
  EXPECT_EQ(client.broken(), 0);
  EXPECT_GT(client.resent(), 0U);
}

TEST_F(CameraTest, AnswersTestPacketsUpToJumboFrames) {
  const Client client;
  ASSERT_TRUE(client.connected());
  GError* error = nullptr;
  const guint size = arv_camera_gv_auto_packet_size(client.get(), &error);
  ASSERT_EQ(error, nullptr) << error->message;
  EXPECT_GT(size, 1400U);
  EXPECT_LE(size, 9000U);
}

TEST_F(CameraTest, WithoutPowerItIsLostAndWithPowerItCanBeUsedAgain) {
  {
    const Client client;
    ASSERT_TRUE(client.connected());
    camera_.set_power(false);
    EXPECT_FALSE(camera_.has_power());
    const Client nobody;
    EXPECT_FALSE(nobody.connected());
    camera_.set_power(true);
  }
  Client again;
  ASSERT_TRUE(again.connected());
  again.start(false);
  EXPECT_FALSE(again.next().pixels.empty());
}

TEST_F(CameraTest, GarbageOnTheControlPortHarmsNothing) {
  const int handle = socket_to(kControlPort);
  std::mt19937 random(1);
  constexpr std::array<std::uint8_t, 6> kCodes = {0x02, 0x40, 0x80, 0x82, 0x84, 0x86};
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::uint8_t> packet(random() % 64);
    for (std::uint8_t& byte : packet)
      byte = static_cast<std::uint8_t>(random());
    if (packet.size() >= 8 && i % 2 == 0) {  // a command that is good up to its data
      packet[0] = 0x42;
      packet[1] = packet[2] = packet[4] = 0;
      packet[3] = kCodes[static_cast<std::size_t>(i / 2) % kCodes.size()];
      packet[5] = static_cast<std::uint8_t>(packet.size() - 8);
      if (packet.size() > 11 && i % 4 == 0) packet[8] = packet[9] = 0;  // and an address in range
      if (packet[3] == 0x82 || packet[3] == 0x86) continue;             // would claim control
    }
    send(handle, packet.data(), packet.size(), 0);
  }
  close(handle);
  Client client;
  ASSERT_TRUE(client.connected());
  client.start(false);
  EXPECT_FALSE(client.next().pixels.empty());
}

/// Takes control with plain packets and starts the camera, then stays silent.
void take_control_and_vanish() {
  const int handle = socket_to(kControlPort);
  const auto write_register = [handle](std::uint16_t address, std::uint8_t value) {
    const std::array<std::uint8_t, 16> packet = {0x42,
                                                 1,
                                                 0,
                                                 0x82,
                                                 0,
                                                 8,
                                                 0,
                                                 1,
                                                 0,
                                                 0,
                                                 static_cast<std::uint8_t>(address >> 8),
                                                 static_cast<std::uint8_t>(address & 0xff),
                                                 0,
                                                 0,
                                                 0,
                                                 value};
    std::array<std::uint8_t, 64> answer{};
    EXPECT_EQ(send(handle, packet.data(), packet.size(), 0), 16);
    EXPECT_GT(recv(handle, answer.data(), answer.size(), 0), 0);
  };
  write_register(0x0a00, 2);  // control
  write_register(0x0124, 1);  // AcquisitionStart
  close(handle);
}

TEST_F(CameraTest, AClientThatVanishedLosesControl) {
  take_control_and_vanish();
  EXPECT_TRUE(wait_until([] {
    Client client;
    if (!client.connected() || !client.in_control()) return false;
    client.start(false);
    return !client.next(2).pixels.empty();
  }));
}

TEST(Camera, RefusesASecondOneOnTheSameAddressAndABadRegion) {
  const auto dark = [] { return std::uint8_t{0}; };
  const GigeCamera first(camera_options(), draw_shot, dark);
  EXPECT_THROW(GigeCamera(camera_options(), draw_shot, dark), scan_cell_common::ConnectionError);
  CameraOptions options = camera_options();
  options.region.x = 1000;
  EXPECT_THROW(GigeCamera(options, draw_shot, dark), scan_cell_common::InvalidParameter);
  options = camera_options();
  options.genicam_file = "/nowhere.xml";
  EXPECT_THROW(GigeCamera(options, draw_shot, dark), scan_cell_common::FileError);
}

}  // namespace
}  // namespace scan_cell_sim
