// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_trigger/pulse_generator.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <time.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "arming.h"
#include "scan_cell_common/clock/host_clock.h"

namespace laser_trigger {
namespace {

using scan_cell_common::host_now;
using scan_cell_common::Refused;
using std::chrono::duration_cast;
using std::chrono::nanoseconds;

constexpr nanoseconds kLook{20'000'000};  // [ns] between two checks of the conditions; chosen
constexpr nanoseconds kGuardianPeriod{50'000'000};  // [ns] between two signs of life; chosen
constexpr nanoseconds kIdlePeriod{1'000'000'000};   // [ns] between two writes of zero; chosen

nanoseconds seconds(double value) {
  return nanoseconds(scan_cell_common::from_seconds(value));
}

void sleep_until(std::chrono::steady_clock::time_point time) {
  const auto count = duration_cast<nanoseconds>(time.time_since_epoch()).count();
  timespec deadline;
  deadline.tv_sec = count / 1'000'000'000;
  deadline.tv_nsec = count % 1'000'000'000;
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
  }
}

}  // namespace

PulseGenerator::PulseGenerator(TriggerPort& port, Guardian* guardian, const Settings& settings,
                               const Observer& observer)
    : port_(port), guardian_(guardian), settings_(settings), observer_(observer) {
  write_low();
  thread_ = std::thread(&PulseGenerator::run, this);
  why_not_realtime_ = set_realtime_priority();
}

PulseGenerator::~PulseGenerator() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (status_.armed) disarm_locked("the trigger is shut down");
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
  write_low();
}

std::string PulseGenerator::set_realtime_priority() {
  if (settings_.realtime_priority == 0) return "realtime_priority is 0";
  sched_param priority = {};
  priority.sched_priority = settings_.realtime_priority;
  const int error = pthread_setschedparam(thread_.native_handle(), SCHED_FIFO, &priority);
  if (error == 0) return "";
  return fmt::format(
      "realtime_priority: {} ({}); allow it (rtprio in /etc/security/limits.d), or set 0",
      settings_.realtime_priority, std::strerror(error));
}

void PulseGenerator::check(const Arming& arming) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  check_locked(arming);
}

void PulseGenerator::check_locked(const Arming& arming) const {
  laser_trigger::check(arming, settings_);
  if (status_.armed) throw Refused("trigger", "already armed", "disarm it first");
}

std::uint32_t PulseGenerator::arm(const Arming& arming) {
  std::uint32_t number = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    check_locked(arming);
    if (guardian_ != nullptr) guardian_->alive(true);
    const std::uint8_t first = lasers_of(arming, 1);
    try {
      port_.write(laser_bits(first));
    } catch (...) {
      write_low();
      throw;
    }
    arming_ = arming;
    lit_ = first;
    if (arming_.longest_on == 0 || arming_.longest_on > settings_.longest_on) {
      arming_.longest_on = settings_.longest_on;
    }
    armed_at_ = kept_alive_at_ = guardian_told_at_ = Clock::now();
    number = status_.arming + 1;
    const double rate = arming.pulses ? arming.rate : 0;
    status_ = {true, number, 0, 0, 0, rate, arming.lasers, arming.alternate, "", ""};
  }
  changed_.notify_all();
  observer_.on_change();
  return number;
}

TriggerStatus PulseGenerator::disarm(const std::string& reason) {
  TriggerStatus ended;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!status_.armed) {
      ended.failure = write_low();
      return ended;
    }
    disarm_locked(reason);
    ended = status_;
  }
  changed_.notify_all();
  observer_.on_change();
  return ended;
}

void PulseGenerator::disarm_locked(const std::string& reason) {
  status_.armed = false;
  status_.lasers = lit_ = 0;
  status_.alternate = false;
  status_.message = reason;
  status_.failure = write_low();
}

std::string PulseGenerator::write_low() noexcept {
  std::string failure;
  try {
    port_.write(0);
  } catch (const std::exception& error) {
    failure = error.what();  // an unreachable circuit is written to again every second
  }
  // Even if the write failed: otherwise the guardian would expect signs of life and kill the node.
  try {
    if (guardian_ != nullptr) guardian_->alive(false);
  } catch (const std::exception&) {
    // Without its guardian nothing can be armed again; arm() reports the error.
  }
  return failure;
}

void PulseGenerator::keep_alive() {
  const std::lock_guard<std::mutex> lock(mutex_);
  kept_alive_at_ = Clock::now();
}

TriggerStatus PulseGenerator::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return status_;
}

void PulseGenerator::run() {
  prctl(PR_SET_TIMERSLACK, 1);  // [ns] else the kernel may wake it 50 us late to save power
  while (true) {
    {
      std::unique_lock<std::mutex> lock(mutex_);
      while (!ending_ && !status_.armed) {
        const auto woken = changed_.wait_for(lock, kIdlePeriod);
        if (woken == std::cv_status::timeout && !status_.armed) write_low();
      }
      if (ending_) return;
    }
    generate();
  }
}

std::string PulseGenerator::reason_to_disarm(Clock::time_point now) const {
  if (now - kept_alive_at_ > seconds(settings_.keep_alive_timeout)) {
    return fmt::format("no keep-alive for {:g} s", settings_.keep_alive_timeout);
  }
  if (now - armed_at_ > seconds(arming_.longest_on)) {
    return fmt::format("longest-on time of {:g} s is over", arming_.longest_on);
  }
  return "";
}

bool PulseGenerator::still_armed(std::uint32_t arming) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!status_.armed || status_.arming != arming) return false;
    const Clock::time_point now = Clock::now();
    std::string reason = reason_to_disarm(now);
    if (reason.empty() && guardian_ != nullptr && now - guardian_told_at_ > kGuardianPeriod) {
      try {
        guardian_->alive(true);
        guardian_told_at_ = now;
      } catch (const std::exception& error) {
        reason = error.what();
      }
    }
    if (reason.empty()) return true;
    disarm_locked(reason);
  }
  observer_.on_change();
  return false;
}

bool PulseGenerator::wait_until(Clock::time_point time, std::uint32_t arming) {
  while (true) {
    if (!still_armed(arming)) return false;
    const Clock::time_point now = Clock::now();
    if (now >= time) return true;
    sleep_until(std::min(time, now + kLook));
  }
}

void PulseGenerator::generate() {
  TriggerStatus begin;
  Arming arming;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    begin = status_;
    arming = arming_;
  }
  if (!begin.armed) return;
  if (!arming.pulses) {
    wait_until(Clock::time_point::max(), begin.arming);
    return;
  }
  const nanoseconds period = seconds(1 / arming.rate);
  const nanoseconds exposure = seconds(exposure_of(arming, settings_));
  Clock::time_point deadline = Clock::now() + period;
  Clock::time_point steady = deadline;  // from then on the next pulse's laser is steady
  while (wait_until(std::max(deadline, steady), begin.arming)) {
    const auto late = Clock::now() - deadline;
    if (late * 2 < period) {
      send_pulse(deadline, begin.arming);
      if (arming.alternate)
        steady = take_turns(std::max(deadline + period / 2, edge_ + exposure), begin.arming);
      deadline += period * periods_after(arming, status().pulses);
    } else {
      const auto missed = (late + period / 2) / period;
      const std::lock_guard<std::mutex> lock(mutex_);
      status_.missed += static_cast<std::uint64_t>(missed);
      deadline += period * missed;
    }
  }
}

std::string PulseGenerator::write_or_disarm(std::uint8_t data) {
  try {
    port_.write(data);
    return "";
  } catch (const std::exception& error) {
    disarm_locked(error.what());
    return error.what();
  }
}

PulseGenerator::Clock::time_point PulseGenerator::take_turns(Clock::time_point earliest,
                                                             std::uint32_t arming) {
  std::string failure;
  if (wait_until(earliest, arming)) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (status_.armed && status_.arming == arming) {
      lit_ = lasers_of(arming_, status_.pulses + 1);
      failure = write_or_disarm(laser_bits(lit_));
    }
  }
  if (!failure.empty()) observer_.on_change();
  return Clock::now() + seconds(settings_.laser_rise);
}

void PulseGenerator::send_pulse(Clock::time_point deadline, std::uint32_t arming) {
  Pulse pulse;
  std::string failure;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!status_.armed || status_.arming != arming) return;
    const Nanoseconds late = duration_cast<nanoseconds>(Clock::now() - deadline).count();
    const Nanoseconds before = host_now();
    failure = write_or_disarm(laser_bits(lit_) | kCameraPulse);
    const Nanoseconds after = host_now();
    edge_ = Clock::now();
    if (failure.empty()) {
      // A longer write is delayed after the edge, as the call returns.
      shortest_write_ = std::clamp<Nanoseconds>(after - before, 0, shortest_write_);
      pulse = {before + shortest_write_ / 2, status_.arming, ++status_.pulses, lit_, late};
      status_.latest = std::max(status_.latest, scan_cell_common::to_seconds(late));
    }
  }
  if (failure.empty()) {
    sleep_until(Clock::now() + seconds(settings_.pulse_width));
    const std::lock_guard<std::mutex> lock(mutex_);
    if (status_.armed && status_.arming == arming) failure = write_or_disarm(laser_bits(lit_));
  }
  if (pulse.count > 0) observer_.on_pulse(pulse);
  if (!failure.empty()) observer_.on_change();
}

}  // namespace laser_trigger
