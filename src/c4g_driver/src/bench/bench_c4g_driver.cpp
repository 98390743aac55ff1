// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

// The driver's own delay, from the kernel's stamp of a datagram until its pose is published on /tf,
// 500 times a second, compared with a loop that only receives and publishes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "delay_runs.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/testing/child_process.h"
#include "scan_cell_common/tools/tool_main.h"

using namespace c4g_driver;  // NOLINT
using scan_cell_common::ChildProcess;
using scan_cell_common::Durations;

namespace {

constexpr double kMicroseconds = 1e-3;  // in a nanosecond

void print(const char* what, const Durations& delays, double yardstick) {
  const double most = kMicroseconds * static_cast<double>(delays.quantile(0.99));
  std::printf("  %-28s %6.0f %6.0f %6.0f us", what,
              kMicroseconds * static_cast<double>(delays.quantile(0.5)), most,
              kMicroseconds * static_cast<double>(delays.quantile(0.999)));
  if (yardstick > 0) std::printf("   %.1f times the bare loop; goal 1000 us", most / yardstick);
  std::printf("\n");
}

int measure(const std::string& program, double seconds) {
  const DelayRuns runs(program);
  const BareRun bare = runs.bare(seconds);
  const Durations driver = runs.driver(seconds, 0);
  const double yardstick = kMicroseconds * static_cast<double>(bare.delays.quantile(0.99));
  print("receive and publish", bare.delays, 0);
  print("driver", driver, yardstick);
  try {
    constexpr int kPriority = 50;  // SCHED_FIFO; chosen
    print("driver, realtime_priority 50", runs.driver(seconds, kPriority), yardstick);
  } catch (const scan_cell_common::InvalidParameter& refused) {
    std::printf("  driver, realtime_priority 50: not measured: %s\n", refused.what());
  }
  std::printf("  %lu and %lu poses; publishing takes %.1f allocations a pose, the driver none\n",
              static_cast<unsigned long>(bare.delays.count()),
              static_cast<unsigned long>(driver.count()), bare.allocations);
  return 0;
}

/// Measures with idle and with busy processors, each in its own process.
int measure_all(const std::string& program, double seconds) {
  const std::string port = fmt::format("{}", scan_cell_common::free_port());
  setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + port).c_str(), 1);
  setenv("ROS_IP", "127.0.0.1", 1);
  const ChildProcess master({"rosmaster", "--core", "-p", port}, true);
  const unsigned processors = std::thread::hardware_concurrency();
  for (const unsigned busy : {0u, processors}) {
    std::vector<std::unique_ptr<ChildProcess>> load;
    for (unsigned i = 0; i < busy; ++i)
      load.push_back(
          std::make_unique<ChildProcess>(std::vector<std::string>{program, "--run", "load"}));
    double before[1] = {0};
    getloadavg(before, 1);
    std::printf(
        "datagram to tf, %u of %u processors kept busy, load before %.1f: half, 99 %%, "
        "99.9 %% within\n",
        busy, processors, before[0]);
    std::fflush(stdout);
    ChildProcess run({program, "--run", "measure", "--seconds", fmt::format("{}", seconds)});
    if (const int code = run.wait(); code != 0) return code;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string program = std::filesystem::read_symlink("/proc/self/exe");
  double seconds = 10;
  std::string kind;
  std::uint16_t port = 0;
  CLI::App app("The driver's own delay.");
  app.add_option("--seconds", seconds, "of each run")->check(CLI::Range(1.0, 15.0));
  app.add_option("--run", kind, "for the program itself: measure, source, listener or load");
  app.add_option("--port", port, "for the program itself: of the source");
  return scan_cell_common::tool_main("bench_c4g_driver", app, argc, argv, [&] {
    if (kind.empty()) return measure_all(program, seconds);
    if (kind == "source") return send_to_whoever_asks(port);
    if (kind == "listener") return listen();
    if (kind == "measure") return measure(program, seconds);
    for (volatile unsigned work = 0;; work = work + 1) {
    }
  });
}
