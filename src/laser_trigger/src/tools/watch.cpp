// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cinttypes>
#include <cstdio>

#include "loopback_circuit.h"
#include "scan_cell_common/tools/interrupts.h"
#include "trigger_orders.h"

namespace laser_trigger {
namespace {

using scan_cell_common::CatchInterrupts;
using scan_cell_common::Nanoseconds;
using scan_cell_common::Refused;

/// Prints what changed from one write to the next, one line per change.
class Display {
 public:
  void show(const LoopbackCircuit::Write& write) {
    const auto rose = static_cast<std::uint8_t>(write.data & ~data_);
    const auto fell = static_cast<std::uint8_t>(data_ & ~write.data);
    for (int laser = 0; laser < 2; ++laser) {
      const std::uint8_t line = laser_bits(static_cast<std::uint8_t>(1 << laser));
      if ((rose & line) != 0) print(write.time, fmt::format("laser_{} on", laser));
      if ((fell & line) != 0) print(write.time, fmt::format("laser_{} off", laser));
    }
    if ((rose & kCameraPulse) != 0) print(write.time, fmt::format("pulse {}", ++pulses_));
    data_ = write.data;
  }

  std::uint64_t pulses() const { return pulses_; }

 private:
  static void print(Nanoseconds time, const std::string& what) {
    constexpr Nanoseconds kSecond = 1'000'000'000;  // [ns]
    std::printf("%" PRId64 ".%09" PRId64 "  %s\n", time / kSecond, time % kSecond, what.c_str());
    std::fflush(stdout);
  }

  std::uint8_t data_ = 0;
  std::uint64_t pulses_ = 0;
};

}  // namespace

void watch(const PortAddress& address, double seconds) {
  constexpr double kGlance = 0.05;  // [s] chosen
  if (address.kind == PortAddress::Kind::kParallel) {
    throw Refused("watch", address.name(),
                  "a parallel port cannot be read while another program writes it: watch the topic "
                  "/laser_trigger/events of the node, or give --port loopback");
  }
  LoopbackCircuit circuit(address.host, address.port);
  std::printf("listening on %s as the trigger circuit; Ctrl-C ends it\n",
              circuit.address().name().c_str());
  std::fflush(stdout);
  const auto begin = std::chrono::steady_clock::now();
  const auto over = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    return CatchInterrupts::interrupted() || (seconds > 0 && passed.count() >= seconds);
  };
  Display display;
  while (!over()) {
    const auto write = circuit.take(kGlance);
    if (write) display.show(*write);
  }
  std::printf("%" PRIu64 " pulses", display.pulses());
  if (circuit.refused() > 0)
    std::printf("; %" PRIu64 " datagrams that were not one byte", circuit.refused());
  std::printf("\n");
}

}  // namespace laser_trigger
