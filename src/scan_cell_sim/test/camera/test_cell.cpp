// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <thread>

#include "camera/gige_client.h"
#include "scan_cell_common/errors/errors.h"
#include "test_worlds.h"

namespace scan_cell_sim {
namespace {

/// Motion straight up with a known speed, from 0.4 m over the floor.
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

/// A cell with the camera in the flange; laser_0's plane passes 0.25 - height / 2 left of it.
CellOptions plain_cell() {
  CellOptions options;
  auto& camera = options.scanner.camera;
  camera.width = 1696;
  camera.height = 1710;
  camera.fx = camera.fy = 800;
  camera.cx = 848;
  camera.cy = 855;
  scan_cell_common::LaserPlane laser;
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
  explicit CircuitDriver(std::uint16_t port) : handle_(socket_to(port)) {}
  ~CircuitDriver() { close(handle_); }
  void pulse() const {
    write(0b011);
    write(0b010);
  }
  void write(std::uint8_t data) const { EXPECT_EQ(send(handle_, &data, 1, 0), 1); }

 private:
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
  EXPECT_EQ(after.too_soon, before.too_soon);
  EXPECT_EQ(after.queue_full, before.queue_full);
  // 1 ms later the line is up to 0.1 px further: the pose is that of the pulse, not a later one.
  EXPECT_LT(worst, 0.05);
}

/// At rest 0.4 m over the floor, where both lines are 100 px from the middle: laser_0's to the
/// left, laser_1's to the right.
class Still : public FlangeMotion {
 public:
  Eigen::Isometry3d flange_at(Nanoseconds) const override { return Rising(0).flange_at(0); }
};

constexpr double kExposure = 0.05;  // [s] in which a test can change the lasers

CellOptions cell_of_two_lasers() {
  CellOptions options = plain_cell();
  scan_cell_common::LaserPlane other;
  other.origin = {0.25, 0, 0};
  other.normal = Eigen::Vector3d(-0.5, 0, -0.25).normalized();
  other.distance = other.normal.dot(other.origin);
  options.scanner.lasers.push_back(other);
  options.optics.exposure = kExposure;
  options.optics.brightness = 150;
  options.optics.ambient = 0;
  return options;
}

/// Light left and right of the middle in the middle row.
std::array<double, 2> light_of(const Received& frame) {
  std::array<double, 2> light = {0, 0};
  for (int column = 0; column < frame.region.width; ++column) {
    const std::size_t side = column + frame.region.x < 848 ? 0 : 1;
    light[side] += frame.pixels[static_cast<std::size_t>(256 * frame.region.width + column)];
  }
  return light;
}

TEST(Cell, ShowsBothLinesByTheirLightWhereTheLasersChangePlacesDuringTheExposure) {
  World world;
  world.floor = Floor{};
  const Still motion;
  Cell cell(cell_of_two_lasers(), world, motion);
  Client client;
  ASSERT_TRUE(client.connected());
  arv_camera_set_exposure_time(client.get(), kExposure * 1e6, nullptr);
  client.start(true);
  const CircuitDriver driver(cell.circuit().port());
  ASSERT_TRUE(wait_until([&] {  // until the camera takes pulses
    driver.pulse();
    return !client.next(0.2).pixels.empty();
  }));
  while (!client.next(0.3).pixels.empty()) {
  }
  double whole = 0;                               // light of a line that was on all the time
  for (const double change : {-1.0, 0.3, 0.7}) {  // of the exposure; never
    driver.write(0b010);
    driver.write(0b011);
    const Nanoseconds pulse = host_now();
    if (change >= 0) {
      const auto until = pulse + scan_cell_common::from_seconds(change * kExposure);
      ASSERT_TRUE(wait_until([&] { return host_now() >= until; }));
      driver.write(0b100);
    }
    const Received frame = client.next();
    ASSERT_FALSE(frame.pixels.empty());
    const Nanoseconds end = frame.time + scan_cell_common::from_seconds(kExposure);
    const std::array<double, 2> truth = cell.circuit().lit(frame.time, end);
    const std::array<double, 2> light = light_of(frame);
    if (change < 0) {
      whole = light[0];
      EXPECT_EQ(light[1], 0);
      EXPECT_GT(whole, 300);
    }
    EXPECT_NEAR(light[0] / whole, truth[0], 0.03) << change;
    EXPECT_NEAR(light[1] / whole, truth[1], 0.03) << change;
    if (change >= 0) {  // unless the machine stopped for so long that it came too late
      EXPECT_NEAR(truth[0] + truth[1], 1, 1e-6);
      EXPECT_GE(truth[0], change - 1e-3);
    }
    driver.write(0b000);
  }
}

TEST(Cell, ShowsOneLineWhereTheLasersChangePlacesAfterTheExposure) {
  World world;
  world.floor = Floor{};
  const Still motion;
  Cell cell(cell_of_two_lasers(), world, motion);
  Client client;
  ASSERT_TRUE(client.connected());
  client.start(true);  // exposures of 1 ms
  const CircuitDriver driver(cell.circuit().port());
  ASSERT_TRUE(wait_until([&] {
    driver.pulse();
    return !client.next(0.05).pixels.empty();
  }));
  while (!client.next(0.2).pixels.empty()) {
  }
  for (int i = 0; i < 10; ++i) {
    const std::uint8_t laser = i % 2 == 0 ? 0b010 : 0b100;
    driver.write(laser);
    driver.write(laser | 1);
    const Nanoseconds after = host_now() + 2'000'000;
    driver.write(laser);
    ASSERT_TRUE(wait_until([&] { return host_now() > after; }));
    driver.write(laser ^ 0b110);
    const std::array<double, 2> light = light_of(client.next());
    EXPECT_EQ(light[i % 2 == 0 ? 1 : 0], 0);
    EXPECT_GT(light[i % 2 == 0 ? 0 : 1], 0);
  }
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
