// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "laser_trigger/pulse_generator.h"
#include "test_circuit.h"

using namespace laser_trigger;  // NOLINT

namespace {

constexpr std::uint8_t kBoth = 3;

class PulseGeneratorTest : public testing::Test {
 protected:
  PulseGeneratorTest() : port_(open_port(circuit_.address())) { circuit_.start(); }

  void make(const PulseGenerator::Settings& settings) {
    generator_ = std::make_unique<PulseGenerator>(
        *port_, nullptr, settings,
        PulseGenerator::Observer{[this](const Pulse& pulse) {
                                   const std::lock_guard<std::mutex> lock(mutex_);
                                   pulses_.push_back(pulse);
                                 },
                                 [this] { ++changes_; }});
  }
  static PulseGenerator::Settings patient() {
    PulseGenerator::Settings settings;
    settings.keep_alive_timeout = 1000;
    return settings;
  }
  std::vector<Pulse> pulses() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return pulses_;
  }
  bool lines_go_low() {
    return wait_for([this] { return circuit_.data() == 0; });
  }
  bool pulsing() {
    return wait_for([this] { return circuit_.rising_edges().size() >= 3; });
  }

  TestCircuit circuit_;
  std::unique_ptr<TriggerPort> port_;
  std::mutex mutex_;
  std::vector<Pulse> pulses_;
  std::atomic<int> changes_{0};
  std::unique_ptr<PulseGenerator> generator_;
};

}  // namespace

TEST(PulseGenerator, HasTheLinesLowBeforeItSaysThatItIsDisarmed) {
  struct : TriggerPort {
    std::atomic<int> data{255};
    void write(std::uint8_t value) override { data = value; }
  } port;
  PulseGenerator::Settings settings;
  settings.keep_alive_timeout = 0.1;
  std::mutex mutex;
  std::vector<int> at_change;  // from the thread that arms and the pulse thread
  PulseGenerator generator(port, nullptr, settings,
                           {[](const Pulse&) {},
                            [&] {
                              const std::lock_guard<std::mutex> lock(mutex);
                              at_change.push_back(port.data);
                            }});
  generator.arm({100, kBoth, 0});
  generator.disarm("enough");
  EXPECT_EQ(port.data, 0);
  generator.arm({100, kBoth, 0});
  ASSERT_TRUE(wait_for([&] {  // by itself, without a keep-alive
    const std::lock_guard<std::mutex> lock(mutex);
    return at_change.size() == 4;
  }));
  EXPECT_EQ(at_change[1], 0);
  EXPECT_EQ(at_change[3], 0);
}

TEST(PulseGenerator, SaysWhereTheLinesCouldNotBeWrittenLow) {
  struct : TriggerPort {
    std::atomic<bool> lost{false};
    void write(std::uint8_t) override {
      if (lost) throw scan_cell_common::ConnectionError("circuit", "gone", "look for it");
    }
  } port;
  PulseGenerator generator(port, nullptr, {}, {[](const Pulse&) {}, [] {}});
  generator.arm({0.1, kBoth, 0});  // no pulse in between
  EXPECT_EQ(generator.disarm("enough").failure, "");
  generator.arm({0.1, kBoth, 0});
  port.lost = true;
  EXPECT_EQ(generator.disarm("enough").failure, "circuit: gone; look for it");
  EXPECT_EQ(generator.disarm("again").failure, "circuit: gone; look for it");
}

TEST(PulseGenerator, AWriteThatIsHeldUpDoesNotShiftItsEvent) {
  struct : TriggerPort {
    std::mutex mutex;
    std::vector<std::int64_t> edges;
    void write(std::uint8_t value) override {
      if ((value & kCameraPulse) == 0) return;
      constexpr std::size_t kHeldUp = 4;  // every fourth pulse
      constexpr auto kFor = std::chrono::milliseconds(8);
      const std::lock_guard<std::mutex> lock(mutex);
      edges.push_back(scan_cell_common::host_now());
      if (edges.size() % kHeldUp == 0) std::this_thread::sleep_for(kFor);
    }
  } port;
  std::mutex mutex;
  std::vector<std::int64_t> events;
  PulseGenerator::Settings settings;
  settings.keep_alive_timeout = 1000;
  PulseGenerator generator(port, nullptr, settings,
                           {[&](const Pulse& pulse) {
                              const std::lock_guard<std::mutex> lock(mutex);
                              events.push_back(pulse.time);
                            },
                            [] {}});
  constexpr std::size_t kPulses = 20;
  generator.arm({50, kBoth, 0});
  ASSERT_TRUE(wait_for([&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return events.size() >= kPulses;
  }));
  generator.disarm("enough");
  ASSERT_LE(events.size(), port.edges.size());
  int shifted = 0;
  for (std::size_t i = 0; i < events.size(); ++i)
    shifted += std::abs(events[i] - port.edges[i]) > 2'000'000;
  EXPECT_LE(shifted, 1) << "a busy machine may hold one up before its edge";
}

TEST_F(PulseGeneratorTest, SetsAllLinesLowAtTheStart) {
  port_->write(0xff);
  make(patient());
  EXPECT_TRUE(lines_go_low());
}

TEST_F(PulseGeneratorTest, SetsAllLinesLowAgainWhileItIsIdle) {
  make(patient());
  port_->write(0xff);  // another program, or a circuit switched on late
  EXPECT_TRUE(lines_go_low());
}

TEST_F(PulseGeneratorTest, PulsesOnItsDeadlinesWithAnEventOfEachRisingEdge) {
  make(patient());
  constexpr double kRate = 200;
  constexpr std::size_t kPulses = 100;
  EXPECT_EQ(generator_->arm({kRate, kBoth, 0}), 1U);
  ASSERT_TRUE(wait_for([this] { return pulses().size() >= kPulses; }));
  const TriggerStatus ended = generator_->disarm("enough");
  ASSERT_TRUE(lines_go_low());
  const std::vector<Pulse> events = pulses();
  const std::vector<std::int64_t> edges = circuit_.rising_edges();
  ASSERT_EQ(events.size(), edges.size());
  EXPECT_EQ(ended.pulses, edges.size());
  constexpr std::int64_t kPeriod = 5'000'000;
  std::vector<std::int64_t> phases;
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(events[i].count, i + 1);
    EXPECT_EQ(events[i].arming, 1U);
    EXPECT_EQ(events[i].lasers, kBoth);
    // The event is never later than the edge's arrival by more than the time of the write itself.
    EXPECT_LT(events[i].time - edges[i], 2'000'000);
    // Nor more than a period off its deadline: deadlines are absolute, so errors do not add up.
    const std::int64_t since = events[i].time - events[0].time;
    const std::int64_t deadlines = (since + kPeriod / 2) / kPeriod;
    EXPECT_GE(deadlines, static_cast<std::int64_t>(i));
    phases.push_back(std::abs(since - deadlines * kPeriod));
    if (i > 0) {
      EXPECT_GT(events[i].time - events[i - 1].time, kPeriod / 2 - 1'000'000);
    }
  }
  const std::int64_t since = events.back().time - events.front().time;
  const auto missed = static_cast<std::int64_t>(ended.missed);
  EXPECT_NEAR(static_cast<double>(since) / kPeriod,
              static_cast<double>(events.size() - 1) + static_cast<double>(missed), 1.01 + missed);
}

TEST_F(PulseGeneratorTest, KeepsTheLasersOnBetweenThePulsesAndOnlyWhileArmed) {
  make(patient());
  generator_->arm({100, 1, 0});
  ASSERT_TRUE(pulsing());
  generator_->disarm("enough");
  ASSERT_TRUE(lines_go_low());
  bool on = false;
  for (const TestCircuit::Write& write : circuit_.writes()) {
    if (write.data == kLaser0) on = true;
    EXPECT_TRUE(write.data == 0 || write.data == kLaser0 || write.data == (kLaser0 | kCameraPulse));
    EXPECT_EQ(write.data & kLaser1, 0);
  }
  EXPECT_TRUE(on);
}

TEST_F(PulseGeneratorTest, GoesLowWithoutAKeepAlive) {
  PulseGenerator::Settings settings;
  settings.keep_alive_timeout = 0.2;
  make(settings);
  generator_->arm({100, kBoth, 0});
  ASSERT_TRUE(pulsing());
  EXPECT_TRUE(lines_go_low());
  EXPECT_NE(generator_->status().message.find("keep-alive"), std::string::npos);
  EXPECT_FALSE(generator_->status().armed);
  EXPECT_EQ(changes_, 2);
}

TEST_F(PulseGeneratorTest, StaysOnWhileItIsKeptAlive) {
  PulseGenerator::Settings settings;
  settings.keep_alive_timeout = 2;  // generous: the test machine may be busy
  make(settings);
  generator_->arm({50, kBoth, 0});
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(3);
  while (std::chrono::steady_clock::now() < end) {
    generator_->keep_alive();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_TRUE(generator_->status().armed);
}

TEST_F(PulseGeneratorTest, GoesLowAfterTheLongestOnTimeAtALowRateToo) {
  make(patient());
  generator_->arm({0.1, kBoth, 0.3});
  ASSERT_TRUE(wait_for([this] { return circuit_.data() == (kLaser0 | kLaser1); }));
  EXPECT_TRUE(lines_go_low());
  EXPECT_NE(generator_->status().message.find("longest-on"), std::string::npos);
}

TEST_F(PulseGeneratorTest, NeverStaysOnLongerThanItsOwnLimit) {
  PulseGenerator::Settings settings = patient();
  settings.longest_on = 0.3;
  make(settings);
  generator_->arm({100, kBoth, 1e9});
  ASSERT_TRUE(pulsing());
  EXPECT_TRUE(lines_go_low());
}

TEST_F(PulseGeneratorTest, GoesLowWhenItIsDestroyed) {
  make(patient());
  generator_->arm({100, kBoth, 0});
  ASSERT_TRUE(pulsing());
  generator_.reset();
  EXPECT_TRUE(lines_go_low());
}

TEST_F(PulseGeneratorTest, DisarmsWithTheReasonWhenTheCircuitIsLost) {
  make(patient());
  generator_->arm({100, kBoth, 0});
  ASSERT_TRUE(pulsing());
  circuit_.stop();
  EXPECT_TRUE(wait_for([this] { return !generator_->status().armed; }));
  EXPECT_NE(generator_->status().message.find("no trigger circuit listens"), std::string::npos);
  EXPECT_THROW(generator_->arm({100, kBoth, 0}), NoDevice);
}

TEST_F(PulseGeneratorTest, RefusesWhatMakesNoSenseAndSwitchesNothingOn) {
  make(patient());
  using scan_cell_common::Refused;
  for (const double rate : {0.0, -5.0, 1e-11, 0.09, 1e6, std::nan(""), HUGE_VAL})
    EXPECT_THROW(generator_->arm({rate, 1, 0}), Refused) << rate;
  EXPECT_THROW(generator_->arm({100, 4, 0}), Refused);
  EXPECT_THROW(generator_->arm({100, 1, -1}), Refused);
  generator_->arm({100, 1, 0});
  EXPECT_THROW(generator_->arm({100, 1, 0}), Refused);
  generator_->disarm("enough");
  for (const TestCircuit::Write& write : circuit_.writes())
    EXPECT_EQ(write.data & kLaser1, 0);
}

TEST_F(PulseGeneratorTest, SwitchesALaserOnWithoutPulses) {
  make(patient());
  generator_->arm({0, 2, 0.3, false});
  ASSERT_TRUE(wait_for([this] { return circuit_.data() == kLaser1; }));
  EXPECT_EQ(generator_->status().rate, 0);
  EXPECT_TRUE(lines_go_low());
  EXPECT_NE(generator_->status().message.find("longest-on"), std::string::npos);
  EXPECT_TRUE(circuit_.rising_edges().empty());
}

TEST_F(PulseGeneratorTest, NumbersItsArmings) {
  make(patient());
  EXPECT_EQ(generator_->arm({100, 0, 0}), 1U);
  EXPECT_EQ(generator_->disarm("enough").arming, 1U);
  EXPECT_EQ(generator_->disarm("again").arming, 0U);
  EXPECT_EQ(generator_->arm({100, 0, 0}), 2U);
  ASSERT_TRUE(pulsing());
  EXPECT_EQ(pulses().front().count, 1U);
}
