// Copyright 2026 the scan cell developers SPDX-License-Identifier: BSD-3-Clause Measures the pulses
// of the loopback port by the kernel's time of receipt: their delay after the deadline, their
// period, and the error of their events' stamps. A plain thread with absolute clock_nanosleep
// deadlines of the same rate and scheduling runs at the same time for comparison. Runs with normal
// and real-time scheduling, on an idle and on a loaded machine.
#include <fmt/format.h>
#include <pthread.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "distribution.h"
#include "edge_listener.h"
#include "laser_trigger/pulse_generator.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/tools/tool_main.h"

using namespace laser_trigger;  // NOLINT

namespace {

constexpr double kMicrosecond = 1e3;  // [ns]
constexpr double kSecond = 1e9;       // [ns]
constexpr double kGoal = 50;          // [us] largest error of a stamp; chosen
constexpr int kPriority = 80;         // SCHED_FIFO; chosen

struct Options {
  double rate = 500;    //!< [Hz]
  double seconds = 10;  //!< of each of the four runs
};

/// Keeps every processor busy, with one more thread waiting.
class Load {
 public:
  Load() {
    for (unsigned i = 0; i <= std::thread::hardware_concurrency(); ++i)
      threads_.emplace_back([this] { work(); });
  }
  ~Load() {
    ending_ = true;
    for (std::thread& thread : threads_)
      thread.join();
  }

 private:
  void work() const {
    std::vector<double> memory(1 << 20, 1.0);
    while (!ending_) {
      for (double& value : memory)
        value = std::sqrt(value + 1);
    }
  }

  std::atomic<bool> ending_{false};
  std::vector<std::thread> threads_;
};

/// The simplest way to wake up at a steady rate; measures how late it wakes up.
class PlainThread {
 public:
  PlainThread(double rate, int priority)
      : period_(static_cast<std::int64_t>(kSecond / rate)), thread_([this] { run(); }) {
    sched_param parameters{};
    parameters.sched_priority = priority;
    if (priority > 0) pthread_setschedparam(thread_.native_handle(), SCHED_FIFO, &parameters);
  }
  Distribution stop() {
    ending_ = true;
    thread_.join();
    return late_;
  }

 private:
  static std::int64_t now() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
  }
  void run() {
    for (std::int64_t deadline = now() + period_; !ending_; deadline += period_) {
      const timespec until{deadline / 1'000'000'000, deadline % 1'000'000'000};
      clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
      const std::int64_t late = now() - deadline;
      late_.add(static_cast<double>(late) / kMicrosecond);
      deadline += late / period_ * period_;  // like the trigger, skips what it missed
    }
  }

  const std::int64_t period_;
  std::atomic<bool> ending_{false};
  Distribution late_;
  std::thread thread_;
};

struct Measured {
  Distribution late;     // edge at the receiver, after its deadline
  Distribution period;   // error of the time between two edges
  Distribution stamp;    // absolute error of an event's stamp
  Distribution plain;    // of the plain thread: after its deadline
  TriggerStatus status;  // at the end
};

Measured compare(const std::vector<Pulse>& pulses, const std::vector<std::int64_t>& edges,
                 double rate) {
  if (pulses.size() != edges.size())
    throw scan_cell_common::Refused(
        "the wire", fmt::format("{} edges of {} pulses", edges.size(), pulses.size()),
        "run it again on a less busy machine");
  Measured measured;
  const double period = kSecond / rate;
  for (std::size_t i = 0; i < pulses.size(); ++i) {
    const auto error = static_cast<double>(edges[i] - pulses[i].time);
    measured.stamp.add(std::abs(error) / kMicrosecond);
    measured.late.add((static_cast<double>(pulses[i].late) + error) / kMicrosecond);
    if (i == 0) continue;
    const auto distance = static_cast<double>(edges[i] - edges[i - 1]);
    measured.period.add(std::abs(distance - std::round(distance / period) * period) / kMicrosecond);
  }
  return measured;
}

Measured measure(const Options& options, int priority, TriggerPort& port, Guardian& guardian,
                 EdgeListener& listener) {
  std::mutex mutex;
  std::vector<Pulse> pulses;
  PulseGenerator::Settings settings;
  settings.realtime_priority = priority;
  settings.keep_alive_timeout = 2 * options.seconds;
  PulseGenerator generator(port, &guardian, settings,
                           {[&](const Pulse& pulse) {
                              const std::lock_guard<std::mutex> lock(mutex);
                              pulses.push_back(pulse);
                            },
                            [] {}});
  if (priority > 0 && !generator.why_not_realtime().empty())
    throw scan_cell_common::Refused("SCHED_FIFO", "not allowed", generator.why_not_realtime());
  listener.start();
  PlainThread plain(options.rate, priority);
  generator.arm({options.rate, 0, 2 * options.seconds});
  std::this_thread::sleep_for(std::chrono::duration<double>(options.seconds));
  const TriggerStatus ended = generator.disarm("measured");
  Distribution yardstick = plain.stop();
  constexpr std::chrono::milliseconds kListener(200);  // until it has read the last edge; chosen
  std::this_thread::sleep_for(kListener);
  const std::vector<std::int64_t> edges = listener.stop();
  const std::lock_guard<std::mutex> lock(mutex);
  Measured measured = compare(pulses, edges, options.rate);
  measured.plain = std::move(yardstick);
  measured.status = ended;
  return measured;
}

void report(const Measured& measured) {
  print_quantiles("edge behind its deadline", measured.late);
  print_quantiles("  yardstick: plain thread", measured.plain);
  print_quantiles("period, off by", measured.period);
  print_quantiles("stamp, off by", measured.stamp);
  std::printf(
      "  stamps off by more than %.0f us (goal: none): %.3f %% of %zu; pulses left out: %lu\n",
      kGoal, 100 * measured.stamp.share_above(kGoal), measured.stamp.size(),
      measured.status.missed);
  print_histogram("edges", measured.late, "plain thread", measured.plain);
}

void run(const Options& options, Guardian& guardian) {
  EdgeListener listener;
  constexpr double kHangTimeout = 10;  // [s] chosen
  guardian.watch(listener.address(), kHangTimeout);
  const std::unique_ptr<TriggerPort> port = open_port(listener.address());
  std::printf("%g pulses/s for %g s each, goal: stamps accurate to %.0f us\n", options.rate,
              options.seconds, kGoal);
  for (const bool loaded : {false, true}) {
    const auto load = loaded ? std::make_unique<Load>() : nullptr;
    for (const int priority : {0, kPriority}) {
      std::printf("%s machine, %s scheduling\n", loaded ? "loaded" : "idle",
                  priority == 0 ? "normal" : "SCHED_FIFO");
      try {
        report(measure(options, priority, *port, guardian, listener));
      } catch (const scan_cell_common::Refused& error) {
        std::printf("  not measured: %s\n", error.what());
      }
      std::fflush(stdout);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Pulse timing and accuracy of the stamps, on the loopback port");
  app.add_option("--rate", options.rate, "pulses a second");
  app.add_option("--seconds", options.seconds, "of each run");
  return scan_cell_common::tool_main("bench_laser_trigger", app, argc, argv, [&] {
    Guardian guardian;  // before there are threads
    run(options, guardian);
    return 0;
  });
}
