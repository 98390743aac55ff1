// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <functional>
#include <vector>

#include "camera/loopback.h"
#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_sim/trigger_circuit.h"

namespace scan_cell_sim {
namespace {

using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;

class TriggerCircuitTest : public testing::Test {
 protected:
  TriggerCircuitTest() {
    circuit_.observe([this](const TriggerCircuit::Pulse& pulse) {
      const std::lock_guard<std::mutex> lock(mutex_);
      pulses_.push_back(pulse);
    });
    socket_ = socket_to(circuit_.port());
  }
  ~TriggerCircuitTest() override { close(socket_); }

  void send(const std::vector<std::uint8_t>& bytes) {
    ASSERT_EQ(::send(socket_, bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
    ++sent_;
    wait_until([this] {
      const TriggerCircuit::State state = circuit_.state();
      return state.writes + state.refused == sent_;
    });
  }

  void wait_until(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!condition()) {
      ASSERT_LT(std::chrono::steady_clock::now(), end);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  std::size_t told() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return pulses_.size();
  }

  std::mutex mutex_;
  std::vector<TriggerCircuit::Pulse> pulses_;
  TriggerCircuit circuit_{"127.0.0.1", 0};
  int socket_ = -1;
  std::uint64_t sent_ = 0;
};

TEST_F(TriggerCircuitTest, WithoutPowerNobodyListensAndTheLasersAreOff) {
  send({2});
  circuit_.set_power(false);
  EXPECT_EQ(circuit_.state().lasers, 0);
  const std::uint8_t byte = 3;
  const auto refused = [&] { return ::send(socket_, &byte, 1, 0) < 0 && errno == ECONNREFUSED; };
  wait_until(refused);  // the first send that nobody takes makes the next one fail
  EXPECT_EQ(circuit_.state().writes, 1U);
  circuit_.set_power(true);
  while (::send(socket_, &byte, 1, 0) < 0) {  // what the last failure left behind
  }
  wait_until([this] { return circuit_.state().pulses == 1 && circuit_.state().lasers == 1; });
}

TEST_F(TriggerCircuitTest, OnlyARisingEdgeIsAPulse) {
  for (const std::uint8_t byte : {0, 1, 1, 3, 0, 2, 0, 1})
    send({byte});
  EXPECT_EQ(circuit_.state().pulses, 2U);
  wait_until([this] { return told() == 2; });
}

TEST_F(TriggerCircuitTest, APulseCarriesTheInstantOfTheByteAndTheLasers) {
  const Nanoseconds before = host_now();
  send({4 | 1});
  const Nanoseconds after = host_now();
  wait_until([this] { return told() == 1; });
  const std::lock_guard<std::mutex> lock(mutex_);
  EXPECT_EQ(pulses_[0].lasers, 2);
  EXPECT_GE(pulses_[0].time, before);
  EXPECT_LE(pulses_[0].time, after);
}

TEST_F(TriggerCircuitTest, KeepsTheLasersUntilTheNextWrite) {
  EXPECT_EQ(circuit_.state().lasers, 0);
  send({2});
  EXPECT_EQ(circuit_.state().lasers, 1);
  send({6});
  EXPECT_EQ(circuit_.state().lasers, 3);
  send({0});
  EXPECT_EQ(circuit_.state().lasers, 0);
}

TEST_F(TriggerCircuitTest, RemembersHowLongEachLaserWasOn) {
  const Nanoseconds begin = host_now();
  send({2});
  wait_until([&] { return circuit_.state().longest_on[0] > 0.03; });
  send({2 | 1});  // a pulse does not interrupt it
  send({0});
  const double most = scan_cell_common::to_seconds(host_now() - begin);
  send({2});
  send({0});
  const TriggerCircuit::State state = circuit_.state();
  EXPECT_GT(state.longest_on[0], 0.03);
  EXPECT_LE(state.longest_on[0], most);
  EXPECT_EQ(state.longest_on[1], 0);
}

TEST_F(TriggerCircuitTest, TellsForHowMuchOfAnIntervalEachLaserWasOn) {
  send({2 | 1});
  send({2});
  wait_until([&] { return circuit_.state().longest_on[0] > 0.02; });
  send({4 | 1});  // they change places, at the instant of a pulse
  wait_until([this] { return told() == 2; });
  Nanoseconds first = 0, second = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    first = pulses_[0].time;
    second = pulses_[1].time;
  }
  using Shares = std::array<double, 2>;
  const auto expect = [this](Nanoseconds begin, Nanoseconds end, const Shares& truth) {
    const Shares shares = circuit_.lit(begin, end);
    EXPECT_NEAR(shares[0], truth[0], 1e-6);
    EXPECT_NEAR(shares[1], truth[1], 1e-6);
  };
  const Nanoseconds between = second - first;
  expect(first, second, {1, 0});
  expect(first - between, second, {0.5, 0});
  expect(first, second + between, {0.5, 0.5});
  expect(second - between / 4, second + 3 * between / 4, {0.25, 0.75});
  expect(second, second + between, {0, 1});
  expect(first - 2 * between, first, {0, 0});
}

TEST_F(TriggerCircuitTest, LightCountsAllThatWasSentBeforeItIsAskedFor) {
  constexpr Nanoseconds kMillisecond = 1'000'000;
  for (int i = 0; i < 300; ++i) {  // its own thread may not have heard of it yet
    const bool other = i % 2 != 0;
    const std::uint8_t byte = other ? 4 : 2;
    ASSERT_EQ(::send(socket_, &byte, 1, 0), 1);
    const Nanoseconds now = host_now();
    const std::array<double, 2> shares = circuit_.lit(now, now + kMillisecond);
    ASSERT_EQ(shares[0], other ? 0 : 1);
    ASSERT_EQ(shares[1], other ? 1 : 0);
  }
}

TEST_F(TriggerCircuitTest, RefusesDatagramsThatAreNotOneByte) {
  send({2});
  send({1, 1});
  send({});
  const TriggerCircuit::State state = circuit_.state();
  EXPECT_EQ(state.refused, 2U);
  EXPECT_EQ(state.pulses, 0U);
  EXPECT_EQ(state.lasers, 1);
}

TEST_F(TriggerCircuitTest, RefusesAPortThatIsTaken) {
  EXPECT_THROW(TriggerCircuit("127.0.0.1", circuit_.port()), scan_cell_common::ConnectionError);
  EXPECT_THROW(TriggerCircuit("nowhere", 0), scan_cell_common::InvalidParameter);
}

}  // namespace
}  // namespace scan_cell_sim
