// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "scan_cell_common/clock/clock_map.h"
#include "scan_cell_common/errors/errors.h"

using scan_cell_common::ClockMap;
using scan_cell_common::Nanoseconds;

constexpr Nanoseconds kMillisecond = 1000000;

namespace {

constexpr Nanoseconds kSecond = 1000 * kMillisecond;

/// A device whose messages reach the host over a network with jitter, and the true map of its
/// clock.
class SimulatedDevice {
 public:
  /// @param drift the device runs 1 + drift times as fast @param jitter [ns] mean delay beyond the
  /// least
  SimulatedDevice(unsigned seed, double drift, double jitter)
      : random_(seed), drift_(drift), jitter_(1 / jitter) {}

  /// Sends for this time [ns of the host], at a rate [Hz].
  /// @return [ns] worst error of the map in the second half of that time
  double run(ClockMap& map, Nanoseconds duration, double rate) {
    const Nanoseconds end = now_ + duration, half = now_ + duration / 2;
    double worst = 0;
    while (now_ < end) {
      std::uniform_real_distribution<double> irregular(0.8, 1.2);
      now_ += static_cast<Nanoseconds>(1e9 / rate * irregular(random_));
      const Nanoseconds delay = kMinDelay + static_cast<Nanoseconds>(jitter_(random_));
      map.add(device(), now_ + host_set_ + delay);
      const auto error = static_cast<double>(map.to_host(device()) - now_ - host_set_ - kMinDelay);
      if (now_ > half) worst = std::max(worst, std::abs(error));
    }
    return worst;
  }

  void set_the_hosts_clock(Nanoseconds step) { host_set_ += step; }

 private:
  static constexpr Nanoseconds kMinDelay = 50'000;

  Nanoseconds device() const {
    return 3 * kSecond + static_cast<Nanoseconds>(static_cast<double>(now_) * (1 + drift_));
  }

  std::mt19937 random_;
  double drift_;
  std::exponential_distribution<double> jitter_;
  Nanoseconds now_ = 0;
  Nanoseconds host_set_ = 1'700'000'000 * kSecond;
};

constexpr Nanoseconds kWindow = 2 * kSecond;

}  // namespace

TEST(ClockMap, KeepsTheTimeOfAnyClockOverAnyWire) {
  unsigned seed = 0;
  for (const double drift : {-200e-6, -50e-6, 0.0, 100e-6, 200e-6}) {
    for (const double rate : {10.0, 250.0, 500.0}) {
      for (const double jitter : {20e3, 200e3, 2e6}) {
        ClockMap map(kWindow);
        SimulatedDevice device(++seed, drift, jitter);
        const double worst = device.run(map, 60 * kSecond, rate);
        // the expected least delay in the window, and a share of the jitter
        const double pairs = rate * 2;
        EXPECT_LT(worst, 5e3 + jitter * (8 / pairs + 0.02))
            << drift << ", " << rate << " Hz, jitter " << jitter << " ns";
        const double share = std::min(1.0, jitter / rate / 1e3);
        EXPECT_NEAR(map.figures().drift, drift, 3e-6 + 100e-6 * share)
            << rate << " Hz, jitter " << jitter << " ns";
      }
    }
  }
}

TEST(ClockMap, FollowsAClockThatWasSetWithinTheWindow) {
  for (const Nanoseconds step :
       {-30 * kSecond, -5 * kMillisecond, 5 * kMillisecond, 30 * kSecond}) {
    ClockMap map(kWindow);
    SimulatedDevice device(7, 100e-6, 100e3);
    device.run(map, 60 * kSecond, 250);
    device.set_the_hosts_clock(step);
    EXPECT_LT(device.run(map, 6 * kSecond, 250), 0.3 * kMillisecond) << step;  // from 3 s on
    EXPECT_EQ(map.figures().steps, 1u);
    EXPECT_LT(device.run(map, 60 * kSecond, 250), 20e3) << step;
  }
}

TEST(ClockMap, IsNoWorseThanTheLeastDelayBeforeItKnowsTheDrift) {
  ClockMap map(kWindow);
  SimulatedDevice device(9, 200e-6, 100e3);
  EXPECT_LT(device.run(map, 2 * kSecond, 250), 200e-6 * 2e9 + 50e3);
  EXPECT_EQ(map.figures().drift, 0);
}

TEST(ClockMap, MapsExactlyWhereNothingIsDelayed) {
  ClockMap map(kWindow);
  const Nanoseconds offset = 1'700'000'000'000'000'123;
  for (Nanoseconds device = 0; device < 60 * kSecond; device += 10 * kMillisecond) {
    map.add(device, device + offset);
    ASSERT_EQ(map.to_host(device), device + offset);
  }
}

TEST(ClockMap, StartsAnewWhenTheDeviceRestarts) {
  ClockMap map(1000 * kMillisecond);
  map.add(500 * kMillisecond, 600 * kMillisecond);
  map.add(1 * kMillisecond, 900 * kMillisecond);
  EXPECT_EQ(map.to_host(2 * kMillisecond), 901 * kMillisecond);
}

TEST(ClockMap, RefusesToGuessBeforeTheFirstMessage) {
  EXPECT_THROW(ClockMap(1).to_host(0), scan_cell_common::Refused);
  EXPECT_THROW(ClockMap(0), scan_cell_common::InvalidParameter);
}
