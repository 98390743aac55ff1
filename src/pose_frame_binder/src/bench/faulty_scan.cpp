// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "faulty_scan.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace pose_frame_binder {
namespace {

using tecnogamma_camera::CounterRule;
using tecnogamma_camera::CounterStep;
using tecnogamma_camera::CounterUnwrapper;

constexpr double kMillisecond = 1e6;  // [ns]

class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}
  bool hit(double probability) { return uniform(0, 1) < probability; }
  double uniform(double least, double most) {
    return least + (most - least) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  std::uint64_t bits() { return random_(); }
  /// Never early, with a tail, like the delay of an interrupt or a network.
  Nanoseconds late(double mean, double most) {
    return static_cast<Nanoseconds>(std::min(-mean * std::log(1 - uniform(0, 1)), most));
  }

 private:
  std::mt19937_64 random_;
};

/// A frame on its way from the camera to the host.
struct WireFrame {
  std::uint64_t raw_counter = 0;
  Nanoseconds stamp = 0;
  bool told_restart = false;  //!< the camera reconnected before this frame
  bool corrupt = false;
  std::int64_t pulse = -1;
};

void make_pulses(std::size_t count, const FaultShares& shares, bool alternate, Chance& chance,
                 std::vector<FaultyPulse>& pulses) {
  constexpr std::size_t kArming = 20000;
  constexpr std::size_t kSlowStart = 4;  // as in the trigger
  constexpr double kRates[] = {100, 485, 50, 200};
  double time = 0;  // [ns]
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t arming = i / kArming;
    const double period = 1e9 / kRates[arming % std::size(kRates)];
    if (i % kArming == 0) time += 2000 * kMillisecond;
    const bool slow = alternate && i % kArming >= 1 && i % kArming <= kSlowStart;
    time += chance.hit(shares.pulse_missed) || slow ? 2 * period : period;
    FaultyPulse pulse;
    pulse.pulse = {kScanStart + static_cast<Nanoseconds>(time) +
                       chance.late(0.02 * kMillisecond, 0.2 * kMillisecond),
                   static_cast<std::uint32_t>(arming + 1), i % kArming + 1,
                   static_cast<std::uint8_t>(alternate && i % 2 == 1 ? 2 : 1)};
    pulse.arrival = pulse.pulse.time + chance.late(kMillisecond, 5 * kMillisecond);
    if (i > 0) pulse.arrival = std::max(pulse.arrival, pulses.back().arrival);
    pulse.lost = chance.hit(shares.event_lost);
    pulses.push_back(pulse);
  }
}

class Camera {
 public:
  Camera(const CounterRule& rule, const FaultShares& shares, Chance& chance)
      : rule_(rule), shares_(shares), chance_(chance) {
    restart();
  }

  std::vector<WireFrame> see(const std::vector<FaultyPulse>& pulses, FaultyScan& scan) {
    std::size_t burst = 0;
    std::size_t intact = 0;  // frames since the counter slipped or started
    for (std::size_t i = 0; i < pulses.size(); ++i) {
      if (chance_.hit(shares_.restart)) {
        restart();
        told_ = told_ || chance_.hit(0.5);
        scan.faulty[i] = true;
        intact = 0;
      }
      // Two slips that cancel out, without frames between them, cannot be detected.
      constexpr std::size_t kApart = 8;  // frames; chosen
      const bool may_slip = intact >= kApart;
      if (may_slip && chance_.hit(shares_.pulse_not_taken)) {
        intact = 0;
        scan.faulty[i] = true;
        continue;
      }
      if (may_slip && chance_.hit(shares_.frame_invented)) {
        intact = 0;
        const double before = chance_.uniform(0.1, 1.9) * kMillisecond;
        expose(pulses[i].pulse.time - static_cast<Nanoseconds>(before), -1, scan);
        scan.faulty[i] = true;
      }
      expose(pulses[i].pulse.time, static_cast<std::int64_t>(i), scan);
      constexpr std::size_t kBurst = 50;  // frames; chosen
      if (chance_.hit(shares_.burst_lost)) burst = kBurst;
      const bool lost = burst > 0 || chance_.hit(shares_.frame_lost);
      if (burst > 0) --burst;
      const bool spoilt = spoil(wire_.back());
      intact += !spoilt && !lost;
      if (again(lost) || spoilt) scan.faulty[i] = true;
    }
    return std::move(wire_);
  }

 private:
  void restart() {
    // Some start near the end, so that a 24 bit counter also wraps within a million frames.
    const std::uint64_t period = rule_.last - rule_.first + 1;
    const std::uint64_t before_end = 1 + static_cast<std::uint64_t>(chance_.uniform(0, 300));
    counter_ = chance_.hit(0.5) ? rule_.first : rule_.first + period - before_end;
    if (rule_.last > 0xFFFFFF) counter_ = rule_.first;
  }

  void expose(Nanoseconds instant, std::int64_t pulse, FaultyScan& scan) {
    const double drift = std::sin(scan_cell_common::to_seconds(instant - kScanStart) / 300);
    WireFrame frame;
    frame.raw_counter = counter_;
    frame.stamp = instant + static_cast<Nanoseconds>((4 + 0.3 * drift) * kMillisecond) +
                  chance_.late(0.06 * kMillisecond, 0.5 * kMillisecond);
    frame.told_restart = std::exchange(told_, false);
    frame.pulse = pulse;
    wire_.push_back(frame);
    scan.turns += counter_ == rule_.last;
    counter_ = counter_ == rule_.last ? rule_.first : counter_ + 1;
  }

  bool spoil(WireFrame& frame) {
    frame.corrupt = chance_.hit(shares_.corrupt);
    const std::uint64_t period = rule_.last - rule_.first + 1;
    if (frame.corrupt) {
      if (chance_.hit(shares_.garbled_counter))
        frame.raw_counter = rule_.first + chance_.bits() % period;
      return true;
    }
    // Only one of them is wrong: a wrong counter with a matching wrong stamp cannot be detected.
    if (chance_.hit(shares_.wrong_counter)) {
      const auto by = static_cast<std::uint64_t>(chance_.uniform(1, 100));
      frame.raw_counter = rule_.first + (frame.raw_counter - rule_.first + by) % period;
      return true;
    }
    if (chance_.hit(shares_.wrong_stamp)) {
      frame.stamp += static_cast<Nanoseconds>(chance_.uniform(-50, 50) * kMillisecond);
      return true;
    }
    return false;
  }

  bool again(bool lost) {
    if (lost) {
      told_ = wire_.back().told_restart;
      wire_.pop_back();
      return true;
    }
    if (!chance_.hit(shares_.repeated)) return false;
    WireFrame copy = wire_.back();
    copy.told_restart = false;
    wire_.push_back(copy);
    return true;
  }

  const CounterRule& rule_;
  const FaultShares& shares_;
  Chance& chance_;
  std::uint64_t counter_ = 0;
  bool told_ = false;
  std::vector<WireFrame> wire_;
};

void disorder(std::vector<WireFrame>& wire, double share, Chance& chance, FaultyScan& scan) {
  for (std::size_t i = 3; i < wire.size(); ++i) {
    if (!chance.hit(share)) continue;
    const std::size_t back = i - 1 - static_cast<std::size_t>(chance.uniform(0, 3));
    if (wire[back].told_restart || wire[i].told_restart) continue;
    std::swap(wire[i], wire[back]);
    for (std::size_t k = back; k <= i; ++k)
      if (wire[k].pulse >= 0) scan.faulty[static_cast<std::size_t>(wire[k].pulse)] = true;
  }
}

/// Numbers the frames as the camera's acquisition does: a counter that goes back while the device's
/// clock continues means that it was restarted.
class Numbering {
 public:
  explicit Numbering(const CounterRule& rule) : unwrapper_(rule) {}

  FaultyFrame take(const WireFrame& wire) {
    using Kind = CounterStep::Kind;
    if (wire.told_restart) begin();
    CounterStep step = unwrapper_.unwrap(wire.raw_counter);
    if (step.kind == Kind::kBackward && wire.stamp > last_time_) {
      begin();
      step = unwrapper_.unwrap(wire.raw_counter);
    }
    last_time_ = std::max(last_time_, wire.stamp);
    FaultyFrame frame;
    frame.frame = {acquisition_, step.count, wire.stamp, wire.corrupt ? "packets missing" : ""};
    frame.pulse = wire.pulse;
    return frame;
  }

 private:
  void begin() {
    ++acquisition_;
    unwrapper_.reset();
  }

  CounterUnwrapper unwrapper_;
  std::uint32_t acquisition_ = 1;
  Nanoseconds last_time_ = 0;
};

void make_poses(Nanoseconds end, const FaultShares& shares, Chance& chance,
                std::vector<FaultyPose>& poses) {
  const double last = static_cast<double>(end - kScanStart) + 200 * kMillisecond;
  for (double t = 0; t < last; t += chance.uniform(3.5, 4.5) * kMillisecond) {
    if (chance.hit(shares.pose_gap)) t += 80 * kMillisecond;
    if (chance.hit(shares.pose_lost)) continue;
    FaultyPose pose;
    pose.time = kScanStart + static_cast<Nanoseconds>(t);
    const double max_late = chance.hit(shares.pose_late) ? 60 : 1;
    pose.arrival = pose.time + static_cast<Nanoseconds>(chance.uniform(0, max_late) * kMillisecond);
    pose.finite = !chance.hit(shares.pose_unusable);
    poses.push_back(pose);
  }
  std::stable_sort(poses.begin(), poses.end(),
                   [](const FaultyPose& a, const FaultyPose& b) { return a.arrival < b.arrival; });
}

}  // namespace

FaultyScan::FaultyScan(std::size_t pulse_count, const CounterRule& rule, const FaultShares& shares,
                       unsigned seed, bool alternate) {
  Chance chance(seed);
  make_pulses(pulse_count, shares, alternate, chance, pulses);
  faulty.resize(pulse_count);
  std::vector<WireFrame> wire = Camera(rule, shares, chance).see(pulses, *this);
  disorder(wire, shares.out_of_order, chance, *this);
  Numbering numbering(rule);
  Nanoseconds arrival = 0;
  for (const WireFrame& frame : wire) {
    frames.push_back(numbering.take(frame));
    arrival = std::max(arrival, frame.stamp + chance.late(8 * kMillisecond, 60 * kMillisecond));
    frames.back().arrival = arrival;
  }
  make_poses(pulses.back().pulse.time, shares, chance, poses);
}

}  // namespace pose_frame_binder
