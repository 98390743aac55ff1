// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "trigger_orders.h"

#include <fmt/format.h>

#include <cinttypes>
#include <cmath>
#include <cstdio>

#include "loopback_circuit.h"
#include "scan_cell_common/tools/interrupts.h"

namespace laser_trigger {
namespace {

using scan_cell_common::CatchInterrupts;
using scan_cell_common::ConnectionError;
using scan_cell_common::Refused;
using Clock = std::chrono::steady_clock;

const std::string kDone = "done";
const std::string kSignal = "stopped by a signal";

std::string laser_names(std::uint8_t lasers) {
  if (lasers == 0) return "no laser";
  std::string names;
  for (int i = 0; i < 2; ++i) {
    if ((lasers >> i & 1) != 0)
      names += fmt::format("{}{}", (names.empty() ? "laser_" : ", laser_"), i);
  }
  return names;
}

/// Duration [s] of an order.
double duration(const Order& order) {
  if (order.pulses == 0) return order.seconds;
  const std::uint64_t slow = order.alternate ? PulseGenerator::kSlowStart : 0;
  return static_cast<double>(order.pulses + slow) / order.rate;
}

void check(const Order& order) {
  const double seconds = duration(order);
  if (seconds > 0 && seconds <= kLongestOn) return;  // refuses NaN too
  throw Refused(
      "duration", fmt::format("{:g} s", seconds),
      fmt::format("give a duration above 0 and up to {} s", static_cast<int>(kLongestOn)));
}

/// Keeps the circuit armed until the order is done, a signal arrives, or it disarms itself.
TriggerStatus wait_for_end(PulseGenerator& generator, const Order& order) {
  constexpr auto kGlance = std::chrono::milliseconds(20);  // [ms] chosen
  const auto begin = Clock::now();
  const auto end = begin + std::chrono::duration_cast<Clock::duration>(
                               std::chrono::duration<double>(duration(order)));
  while (generator.status().armed) {
    generator.keep_alive();
    const auto now = Clock::now();
    if (CatchInterrupts::interrupted()) {
      generator.disarm(kSignal);
    } else if (order.pulses == 0 && now >= end) {
      generator.disarm(kDone);
    } else {
      std::this_thread::sleep_until(order.pulses == 0 ? std::min(end, now + kGlance)
                                                      : now + kGlance);
    }
  }
  return generator.status();
}

/// @throw scan_cell_common::Error unless the order was done and the lines are low
void tell(const TriggerStatus& ended, double seconds) {
  constexpr double kMilliseconds = 1e3;  // in a second
  char said[200];
  if (ended.rate > 0) {
    std::snprintf(said, sizeof said,
                  "%" PRIu64 " pulses in %.3f s, %" PRIu64 " left out, the latest %.3f ms late",
                  ended.pulses, seconds, ended.missed, ended.latest * kMilliseconds);
  } else {
    std::snprintf(said, sizeof said, "off after %.3f s", seconds);
  }
  if (!ended.failure.empty()) {
    throw ConnectionError("trigger lines", "may be high (" + ended.failure + ")",
                          "switch the lasers off by hand");
  }
  if (ended.message == kDone) {
    std::printf("%s; all lines are low\n", said);
  } else if (ended.message == kSignal) {
    throw Refused(kSignal, said, "all lines are low; give the command again");
  } else {
    throw ConnectionError("switched off by itself", ended.message,
                          "all lines are low; " + std::string(said));
  }
}

}  // namespace

void carry_out(const Order& order, const PortAddress& address) {
  constexpr double kHangTimeout = 2;  // [s] chosen
  constexpr double kMargin = 1;       // [s] added for the pulse thread's own limit; chosen
  check(order);
  Guardian guardian;  // before there are threads
  guardian.watch(address, kHangTimeout);
  const std::unique_ptr<TriggerPort> port = open_port(address);
  PulseGenerator::Settings settings;
  settings.longest_on = kLongestOn + kMargin;
  std::unique_ptr<PulseGenerator> generator;
  const auto count = [&](const Pulse& pulse) {
    if (pulse.count == order.pulses) generator->disarm(kDone);
  };
  generator = std::make_unique<PulseGenerator>(*port, &guardian, settings,
                                               PulseGenerator::Observer{count, [] {}});
  if (order.rate > 0 && !generator->why_not_realtime().empty()) {
    std::fprintf(stderr, "trigger: pulses without real-time scheduling: %s\n",
                 generator->why_not_realtime().c_str());
  }
  const double longest_on = order.pulses > 0 ? 0 : order.seconds + kMargin;
  const auto begin = Clock::now();
  generator->arm({order.rate, order.lasers, longest_on, order.rate > 0, order.alternate});
  std::printf("%s %s; Ctrl-C ends it\n", laser_names(order.lasers).c_str(),
              order.alternate ? "in turn" : "on");
  std::fflush(stdout);
  const TriggerStatus ended = wait_for_end(*generator, order);
  tell(ended, std::chrono::duration<double>(Clock::now() - begin).count());
}

}  // namespace laser_trigger
