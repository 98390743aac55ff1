// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/controller_loop.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_cell_sim {
namespace {

using scan_cell_common::Endpoint;
using scan_cell_common::from_seconds;
using scan_cell_common::host_now;
using scan_cell_common::InvalidParameter;
using scan_cell_common::Nanoseconds;

constexpr std::size_t kMaxBytes = 1400;  // [bytes] of a datagram; c4g_protocol.md

void check_stream_period(double period) {
  constexpr double kShortest = 0.002, kLongest = 0.010;  // [s] as the parameter stream_period
  if (period >= kShortest && period <= kLongest) return;
  throw InvalidParameter("stream period", fmt::format("{} s", period),
                         "give one from 0.002 to 0.010 s");
}

}  // namespace

void ControllerFaults::check() const {
  constexpr double kMaxDrift = 0.5;  // of the host's rate; chosen
  scan_cell_sim::check(to_client, "to_client/");
  scan_cell_sim::check(from_client, "from_client/");
  if (std::abs(clock_drift) <= kMaxDrift) return;
  throw InvalidParameter("clock_drift", fmt::format("{}", clock_drift), "give -0.5 .. 0.5");
}

ControllerLoop::ControllerLoop(const ControllerOptions& options, const Joints& start)
    : options_(options),
      socket_(Endpoint::parse("controller address", options.address, options.port), "controller",
              "stop the program that uses the port, or give another port"),
      motion_(start),
      clock_(host_now()),
      server_(make_server()),
      incoming_(options.faults.seed),
      outgoing_(options.faults.seed + 1) {
  check_stream_period(options.stream_period);
  set_faults(options.faults);
  adopted_.seed = options.faults.seed;
  motion_.select(options.mode, host_now());
  motion_.switch_drives(true, Readiness::Source::kPanel, host_now());
  thread_ = std::thread([this] { serve(); });
}

ControllerLoop::~ControllerLoop() {
  ending_ = true;
  thread_.join();
}

std::unique_ptr<ProtocolServer> ControllerLoop::make_server() {
  return std::make_unique<ProtocolServer>(motion_, clock_, options_);
}

void ControllerLoop::set_faults(const ControllerFaults& faults) {
  faults.check();
  const std::lock_guard<std::mutex> lock(mutex_);
  faults_ = faults;
  faults_since_ = host_now();
}

ControllerFaults ControllerLoop::faults() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  ControllerFaults present = faults_;
  const Nanoseconds passed = host_now() - faults_since_;
  for (WireFaults* const wire : {&present.to_client, &present.from_client})
    wire->link_down = wire->link_down || passed < from_seconds(wire->silence);
  return present;
}

void ControllerLoop::restart(double dark) {
  if (!(dark >= 0)) {
    throw InvalidParameter("restart", fmt::format("{} s", dark), "give 0 s or more");
  }
  const Nanoseconds now = host_now();
  const std::lock_guard<std::mutex> lock(mutex_);
  motion_.power_off(now);
  dark_until_ = now + from_seconds(dark);
}

/// Whether the controller is on. Starts it again when a restart is over.
bool ControllerLoop::is_on(Nanoseconds now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!dark_until_) return true;
  if (now < *dark_until_) return false;
  dark_until_.reset();
  clock_.restart(now);
  motion_.power_on(now);
  server_ = make_server();
  return true;
}

void ControllerLoop::serve() {
  Nanoseconds tick = host_now();
  while (!ending_) {
    const Nanoseconds next =
        std::min({tick, incoming_.next_due().value_or(tick), outgoing_.next_due().value_or(tick)});
    socket_.wait(scan_cell_common::to_seconds(next - host_now()));
    const ControllerFaults present = faults();
    adopt(present);
    const Nanoseconds heard = host_now();  // all before this was received: planning is no silence
    receive(present.from_client);
    answer_received(present.to_client);
    const Nanoseconds now = host_now();
    if (now >= tick) {
      if (is_on(now)) stream(present.to_client, heard);
      const Nanoseconds period = from_seconds(server_->stream_period());
      tick += period;
      if (tick < now || tick > now + period) tick = now + period;  // late, or the clock was set
    }
    send_due();
  }
}

void ControllerLoop::adopt(const ControllerFaults& faults) {
  if (faults.clock_drift != adopted_.clock_drift) clock_.set_drift(faults.clock_drift, host_now());
  if (faults.seed != adopted_.seed) {
    incoming_.seed(faults.seed);
    outgoing_.seed(faults.seed + 1);
  }
  adopted_ = faults;
}

void ControllerLoop::stream(const WireFaults& faults, Nanoseconds heard) {
  server_->watch(heard);
  const Nanoseconds now = host_now();
  const auto datagram = server_->stream(now);
  if (datagram) outgoing_.put({*server_->client(), *datagram}, faults, now);
}

void ControllerLoop::receive(const WireFaults& faults) {
  char bytes[kMaxBytes];
  while (const auto datagram = socket_.receive(bytes, sizeof bytes)) {
    if (datagram->cut) continue;
    incoming_.put({datagram->from, std::string(bytes, datagram->size)}, faults, host_now());
  }
}

void ControllerLoop::answer_received(const WireFaults& faults) {
  while (const auto request = incoming_.take(host_now())) {
    const Nanoseconds now = host_now();
    if (!is_on(now)) continue;
    const auto answer = server_->answer(*request, now);
    if (answer) outgoing_.put({request->peer, *answer}, faults, now);
  }
}

void ControllerLoop::send_due() {
  while (const auto datagram = outgoing_.take(host_now())) {
    socket_.send(datagram->text.data(), datagram->text.size(), datagram->peer);
  }
}

}  // namespace scan_cell_sim
