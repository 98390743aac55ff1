// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <arpa/inet.h>
#include <arv.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <random>
#include <thread>

#include "scan_cell_common/errors.h"
#include "scan_cell_sim/cell.h"
#include "test_worlds.h"

namespace scan_cell_sim {
namespace {

using scan_cell_common::Nanoseconds;

const std::string kConfig = CONFIG_FOLDER;
constexpr const char* kAddress = "127.0.0.1";

Nanoseconds host_now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

bool wait_until(const std::function<bool()>& condition) {
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

/// A GigE Vision client as a product has it: Aravis.
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

  /// Packets that came because they were asked for again.
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

CameraOptions camera_options() {
  CameraOptions options;
  options.genicam_file = kConfig + "/gige_camera.xml";
  return options;
}

/// Pixels that tell everything about the shot they show.
void draw_shot(const GigeCamera::Shot& shot, const Region& region, std::uint8_t* pixels) {
  const auto seed = static_cast<std::uint64_t>(shot.time) + shot.lasers + shot.frame;
  for (int i = 0; i < region.width * region.height; ++i) {
    pixels[i] =
        static_cast<std::uint8_t>((seed >> (i % 8 * 8)) + static_cast<std::uint64_t>(i) / 8);
  }
}

class CameraTest : public testing::Test {
 protected:
  /// Pulses until the camera takes one: its acquisition begins a little after it was told to.
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
  EXPECT_EQ(camera_.counts().overrun, 1U);
  EXPECT_EQ(client.next().time, time);
  EXPECT_EQ(client.next().time, time + 2'000'000);
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
  const int handle = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(3956);
  name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
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
    sendto(handle, packet.data(), packet.size(), 0, reinterpret_cast<sockaddr*>(&name),
           sizeof(name));
  }
  close(handle);
  Client client;
  ASSERT_TRUE(client.connected());
  client.start(false);
  EXPECT_FALSE(client.next().pixels.empty());
}

/// Takes control with plain packets and starts the camera, then never speaks again.
void take_control_and_vanish() {
  const int handle = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(3956);
  name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ASSERT_EQ(connect(handle, reinterpret_cast<sockaddr*>(&name), sizeof(name)), 0);
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

/// Straight up with a known speed, from 0.4 m over the floor.
class Rising : public FlangeMotion {
 public:
  explicit Rising(Nanoseconds begin) : begin_(begin) {}
  double height(Nanoseconds time) const {
    constexpr double kSpeed = 0.1;  // [m/s]
    return 0.4 + kSpeed * scan_cell_common::to_seconds(time - begin_);
  }
  Eigen::Isometry3d flange_at(Nanoseconds time) const override {
    Eigen::Isometry3d flange = pose(0, 0, height(time));
    flange.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
    return flange;
  }

 private:
  Nanoseconds begin_;
};

/// Camera in the flange; laser_0's plane passes 0.25 - height / 2 left of it.
CellOptions plain_cell() {
  CellOptions options;
  auto& camera = options.scanner.camera;
  camera.width = 1696;
  camera.height = 1710;
  camera.fx = camera.fy = 800;
  camera.cx = 848;
  camera.cy = 855;
  laser_triangulation::LaserPlane laser;
  laser.origin = {-0.25, 0, 0};
  laser.normal = Eigen::Vector3d(0.5, 0, -0.25).normalized();
  laser.distance = laser.normal.dot(laser.origin);
  options.scanner.lasers = {laser};
  options.optics.background = options.optics.read_noise = options.optics.shot_noise = 0;
  options.camera = camera_options();
  options.trigger_port = 0;
  return options;
}

double centre(const Received& frame, int row) {
  double sum = 0, moment = 0;
  for (int column = 0; column < frame.region.width; ++column) {
    const int grey = frame.pixels[static_cast<std::size_t>(row * frame.region.width + column)];
    sum += grey;
    moment += static_cast<double>(grey) * (column + frame.region.x);
  }
  return moment / sum;
}

class CircuitDriver {
 public:
  explicit CircuitDriver(std::uint16_t port) : handle_(socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_port = htons(port);
    name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(handle_, reinterpret_cast<sockaddr*>(&name), sizeof(name)), 0);
  }
  ~CircuitDriver() { close(handle_); }
  void pulse() const {
    write(0b011);
    write(0b010);
  }

 private:
  void write(std::uint8_t data) const { EXPECT_EQ(send(handle_, &data, 1, 0), 1); }
  int handle_;
};

TEST(Cell, ThreeHundredPulsesAtAHundredHertzGiveThreeHundredFramesOfTheirPoses) {
  constexpr int kPulses = 300;
  World world;
  world.floor = Floor{};
  const Rising motion(host_now());
  Cell cell(plain_cell(), world, motion);
  Client client;
  ASSERT_TRUE(client.connected());
  client.start(true);
  std::mutex mutex;
  std::map<Nanoseconds, double> true_heights;
  cell.observe([&](const Cell::TrueExposure& exposure) {
    const std::lock_guard<std::mutex> lock(mutex);
    true_heights[exposure.time] = exposure.flange.translation().z();
  });
  const CircuitDriver driver(cell.circuit().port());
  ASSERT_TRUE(wait_until([&] {  // until the camera takes pulses
    driver.pulse();
    return !client.next(0.05).pixels.empty();
  }));
  while (!client.next(0.2).pixels.empty()) {
  }
  const GigeCamera::Counts before = cell.camera().counts();

  std::thread pulses([&] {
    for (int i = 0; i < kPulses; ++i) {  // no deadlines: what is late must not be made up for
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      driver.pulse();
    }
  });
  double worst = 0;
  Nanoseconds last = 0;
  int frames = 0;
  for (; frames < kPulses; ++frames) {
    const Received frame = client.next();
    if (frame.pixels.empty()) break;
    EXPECT_GT(frame.time, last);
    last = frame.time;
    const double height = motion.height(frame.time);
    worst =
        std::max(worst, std::abs(centre(frame, 256) - (848 + 800 * (-0.25 + height / 2) / height)));
    const std::lock_guard<std::mutex> lock(mutex);
    ASSERT_EQ(true_heights.count(frame.time), 1U);
    EXPECT_EQ(true_heights[frame.time], height);
  }
  pulses.join();
  cell.observe(nullptr);
  EXPECT_EQ(frames, kPulses);
  EXPECT_EQ(client.broken(), 0);
  const GigeCamera::Counts after = cell.camera().counts();
  EXPECT_EQ(after.pulses - before.pulses, static_cast<std::uint64_t>(kPulses));
  EXPECT_EQ(after.overrun, before.overrun);
  // 1 ms later the line is up to 0.1 px further: the pose is that of the pulse, not a later one.
  EXPECT_LT(worst, 0.05);
}

TEST(Cell, ShowsAnotherWorldFromTheNextFrameOn) {
  World world;
  world.floor = Floor{};
  const Rising motion(host_now());
  Cell cell(plain_cell(), world, motion);
  world.floor->height = 0.1;
  cell.set_world(world);
  const auto hit = cell.scene()->first_hit({0, 0, 1}, -Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.z(), 0.1, 1e-9);
}

TEST(Cell, ReadsWhereTheRobotStands) {
  EXPECT_NEAR(load_base_link_in_world(kConfig + "/cell.yaml").translation().x(), -0.8, 1e-12);
  EXPECT_THROW(load_base_link_in_world("/nowhere.yaml"), scan_cell_common::FileError);
}

}  // namespace
}  // namespace scan_cell_sim
