// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Lasers that take turns, pulse by pulse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "laser_trigger/pulse_generator.h"
#include "test_circuit.h"

using namespace laser_trigger;  // NOLINT
using scan_cell_common::Refused;

namespace {

constexpr std::uint8_t kBothLasers = 3;
constexpr std::uint8_t kLaserBits = kLaser0 | kLaser1;
constexpr std::size_t kPulses = 60;

PulseGenerator::Arming alternating(double rate, double longest_on = 0) {
  return {rate, kBothLasers, longest_on, true, true};
}

/// Records each write when it ends; one in a given number of laser changes may be held up.
struct RecordingPort : TriggerPort {
  void write(std::uint8_t value) override {
    const std::lock_guard<std::mutex> lock(mutex);
    const std::uint8_t before = writes.empty() ? 0 : writes.back().data;
    const bool turn = (value & kLaserBits) != (before & kLaserBits);
    if (turn && hold_up_every > 0 && ++turns % hold_up_every == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(4));
    writes.push_back({scan_cell_common::host_now(), value});
  }
  std::vector<TestCircuit::Write> written() {
    const std::lock_guard<std::mutex> lock(mutex);
    return writes;
  }
  std::mutex mutex;
  std::vector<TestCircuit::Write> writes;
  int hold_up_every = 0;
  int turns = 0;
};

class Alternating : public testing::Test {
 protected:
  Alternating() { settings_.keep_alive_timeout = 1000; }

  /// Runs until a number of pulses have been sent.
  TriggerStatus run(double rate) {
    PulseGenerator generator(port_, nullptr, settings_,
                             {[this](const Pulse& pulse) {
                                const std::lock_guard<std::mutex> lock(mutex_);
                                pulses_.push_back(pulse);
                              },
                              [] {}});
    PulseGenerator::Arming arming = alternating(rate);
    arming.exposure = exposure_;
    generator.arm(arming);
    EXPECT_TRUE(wait_for([&] { return generator.status().pulses >= kPulses; }));
    return generator.disarm("enough");
  }

  /// Expects each laser to be switched on after the exposure of the previous frame, and long enough
  /// before its own pulse.
  void expect_turns_between_exposures() {
    const auto exposure =
        scan_cell_common::from_seconds(exposure_ > 0 ? exposure_ : settings_.exposure);
    const auto rise = scan_cell_common::from_seconds(settings_.laser_rise);
    const std::vector<TestCircuit::Write> writes = port_.written();
    std::int64_t edge = 0, turn = 0;
    int turns = 0;
    for (std::size_t i = 1; i < writes.size() && writes[i].data != 0; ++i) {
      const auto rose = static_cast<std::uint8_t>(writes[i].data & ~writes[i - 1].data);
      if ((rose & kLaserBits) != 0) {
        turn = writes[i].time;
        EXPECT_TRUE(edge == 0 || turn - edge >= exposure) << turn - edge;
        ++turns;
      }
      if ((rose & kCameraPulse) != 0) {
        edge = writes[i].time;
        EXPECT_GE(edge - turn, rise);
      }
    }
    EXPECT_GE(turns, static_cast<int>(kPulses));
  }

  RecordingPort port_;
  PulseGenerator::Settings settings_;
  double exposure_ = 0;  // [s] of the arming
  std::mutex mutex_;
  std::vector<Pulse> pulses_;
};

}  // namespace

TEST_F(Alternating, TakesTurnsFromLaser0OnAndNeverHasBothOrNoneLit) {
  run(200);
  std::vector<std::uint8_t> at_edges;
  const std::vector<TestCircuit::Write> writes = port_.written();
  std::size_t first = 0;
  while (writes.at(first).data == 0)
    ++first;
  for (std::size_t i = first; i + 2 < writes.size(); ++i) {  // the last are from disarm and the end
    const auto lasers = static_cast<std::uint8_t>(writes[i].data & kLaserBits);
    EXPECT_TRUE(lasers == kLaser0 || lasers == kLaser1) << int{lasers};
    if ((writes[i].data & ~writes[i - 1].data & kCameraPulse) != 0) at_edges.push_back(lasers);
  }
  EXPECT_EQ(writes.back().data, 0);
  ASSERT_EQ(at_edges.size(), pulses_.size());
  for (std::size_t i = 0; i < pulses_.size(); ++i) {
    EXPECT_EQ(pulses_[i].lasers, i % 2 == 0 ? 1 : 2);
    EXPECT_EQ(at_edges[i], laser_bits(pulses_[i].lasers)) << "the event tells what was on";
  }
}

TEST_F(Alternating, ChangesPlacesAfterALongExposureAndBeforeTheNextPulse) {
  settings_.exposure = 3.5e-3;  // longer than half a period
  run(200);
  expect_turns_between_exposures();
}

TEST_F(Alternating, ChangesPlacesHalfAPeriodAfterThePulseWhereTheExposureIsShort) {
  settings_.exposure = 1e-5;
  run(50);
  expect_turns_between_exposures();
  std::vector<std::int64_t> waits;
  std::int64_t edge = 0;
  const std::vector<TestCircuit::Write> writes = port_.written();
  for (std::size_t i = 1; i < writes.size() && writes[i].data != 0; ++i) {
    const auto rose = static_cast<std::uint8_t>(writes[i].data & ~writes[i - 1].data);
    if ((rose & kCameraPulse) != 0) edge = writes[i].time;
    if ((rose & kLaserBits) != 0 && edge != 0) waits.push_back(writes[i].time - edge);
  }
  ASSERT_GE(waits.size(), kPulses - 1);
  std::nth_element(waits.begin(), waits.begin() + waits.size() / 2, waits.end());
  // On a busy machine some pulses are late.
  EXPECT_GT(waits[waits.size() / 2], 8'000'000);
}

TEST_F(Alternating, APulseWaitsForALaserThatCameLate) {
  port_.hold_up_every = 3;
  settings_.laser_rise = 1.5e-3;
  run(200);
  expect_turns_between_exposures();
}

TEST_F(Alternating, TheFirstPulsesComeTwiceAsFarApart) {
  constexpr double kPeriod = 20e6;  // [ns]
  const TriggerStatus ended = run(50);
  ASSERT_GE(pulses_.size(), kPulses);
  const auto deadline = [this](std::size_t i) {
    return static_cast<double>(pulses_[i].time - pulses_[i].late);
  };
  for (std::size_t i = 0; i < pulses_.size(); ++i) {
    const std::size_t expected = i + std::min<std::size_t>(i, PulseGenerator::kSlowStart);
    const auto periods = std::lround((deadline(i) - deadline(0)) / kPeriod);
    EXPECT_GE(periods, static_cast<long>(expected)) << i;
    EXPECT_LE(periods, static_cast<long>(expected + ended.missed)) << i;
  }
}

TEST_F(Alternating, RefusesWhatMakesNoSenseByNameAndSwitchesNothingOn) {
  settings_.exposure = 3e-3;
  settings_.laser_rise = 1e-3;
  PulseGenerator generator(port_, nullptr, settings_, {[](const Pulse&) {}, [] {}});
  const auto refusal = [&](const PulseGenerator::Arming& arming) -> std::string {
    try {
      generator.arm(arming);
    } catch (const Refused& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(alternating(251)),
            "rate: 251 Hz to alternate; give up to 250 Hz: the exposure of 3 ms and the laser's "
            "rise time of 1 ms must fit between two pulses");
  for (const std::uint8_t lasers : {0, 1, 2})
    EXPECT_NE(refusal({100, lasers, 0, true, true}).find("to alternate"), std::string::npos);
  EXPECT_NE(refusal({0, kBothLasers, 0, false, true}).find("without pulses"), std::string::npos);
  for (const TestCircuit::Write& write : port_.written())
    EXPECT_EQ(write.data, 0);
  EXPECT_EQ(refusal(alternating(250)), "");
  generator.disarm("enough");
  EXPECT_EQ(refusal({251, kBothLasers, 0}), "") << "both at once need no turn";
}

TEST_F(Alternating, HoldsTheLasersForTheExposureThatTheArmingTells) {
  settings_.exposure = 0.0005;
  exposure_ = 0.004;  // more than half of the period of 6.7 ms
  run(150);
  expect_turns_between_exposures();
}

TEST_F(Alternating, RefusesAnExposureThatDoesNotFitBetweenTwoPulses) {
  PulseGenerator generator(port_, nullptr, settings_, {[](const Pulse&) {}, [] {}});
  const auto refusal = [&generator](double exposure) -> std::string {
    PulseGenerator::Arming arming = alternating(150);
    arming.exposure = exposure;
    try {
      generator.arm(arming);
    } catch (const Refused& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal(0.0066).find("the exposure of 6.7 ms"), std::string::npos) << "with its delay";
  EXPECT_NE(refusal(-1).find("exposure: -1 s"), std::string::npos);
  EXPECT_NE(refusal(std::nan("")).find("exposure: nan s"), std::string::npos);
  EXPECT_EQ(refusal(0.006), "");
}

TEST_F(Alternating, SaysSoInItsStatusOnlyWhileItIsArmed) {
  PulseGenerator generator(port_, nullptr, settings_, {[](const Pulse&) {}, [] {}});
  generator.arm(alternating(100));
  EXPECT_EQ(generator.status().lasers, kBothLasers);
  EXPECT_TRUE(generator.status().alternate);
  generator.disarm("enough");
  EXPECT_EQ(generator.status().lasers, 0);
  EXPECT_FALSE(generator.status().alternate);
}

namespace {

/// A generator whose lasers take turns on the real loopback wire.
class AlternatingOnTheWire : public testing::Test {
 protected:
  AlternatingOnTheWire() : port_(open_port(circuit_.address())) {
    circuit_.start();
    settings_.keep_alive_timeout = 1000;
  }
  void start(double longest_on = 0) {
    generator_ = std::make_unique<PulseGenerator>(
        *port_, nullptr, settings_, PulseGenerator::Observer{[](const Pulse&) {}, [] {}});
    generator_->arm(alternating(100, longest_on));
    ASSERT_TRUE(wait_for([this] { return circuit_.rising_edges().size() >= 3; }));
  }
  /// Expects the lines low, and no laser switched on again by a change that was in progress.
  void expect_dark_for_good() {
    ASSERT_TRUE(wait_for([this] { return circuit_.data() == 0; }));
    const std::size_t writes = circuit_.writes().size();
    // It writes zero every second while idle: by then a change would long have happened.
    if (generator_) {
      ASSERT_TRUE(wait_for([&] { return circuit_.writes().size() > writes; }));
    }
    EXPECT_EQ(circuit_.data(), 0);
    bool dark = false;
    for (const TestCircuit::Write& write : circuit_.writes()) {
      dark = dark || (write.data == 0 && lit_);
      lit_ = lit_ || write.data != 0;
      EXPECT_FALSE(dark && write.data != 0);
    }
    EXPECT_TRUE(dark);
  }

  TestCircuit circuit_;
  std::unique_ptr<TriggerPort> port_;
  PulseGenerator::Settings settings_;
  std::unique_ptr<PulseGenerator> generator_;
  bool lit_ = false;
};

}  // namespace

TEST_F(AlternatingOnTheWire, GoesDarkWhenItIsDisarmed) {
  start();
  generator_->disarm("enough");
  expect_dark_for_good();
}

TEST_F(AlternatingOnTheWire, GoesDarkWithoutAKeepAlive) {
  settings_.keep_alive_timeout = 0.2;
  start();
  expect_dark_for_good();
  EXPECT_NE(generator_->status().message.find("keep-alive"), std::string::npos);
}

TEST_F(AlternatingOnTheWire, GoesDarkAfterTheLongestOnTime) {
  start(0.3);
  expect_dark_for_good();
  EXPECT_NE(generator_->status().message.find("longest-on"), std::string::npos);
}

TEST_F(AlternatingOnTheWire, GoesDarkWhenItIsDestroyed) {
  start();
  generator_.reset();
  expect_dark_for_good();
}

TEST_F(AlternatingOnTheWire, DisarmsWithTheReasonWhenTheCircuitIsLost) {
  start();
  circuit_.stop();
  EXPECT_TRUE(wait_for([this] { return !generator_->status().armed; }));
  EXPECT_NE(generator_->status().message.find("no trigger circuit listens"), std::string::npos);
}
