// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "pose_frame_binder/binder.h"

namespace pose_frame_binder {

constexpr Nanoseconds kMillisecond = 1'000'000;
constexpr Nanoseconds kStart = 1'700'000'000'000'000'000;

/// A time after the start of a scan.
constexpr Nanoseconds at(double milliseconds) {
  return kStart + static_cast<Nanoseconds>(milliseconds * kMillisecond);
}

/// A pose whose x is its own number.
inline TimedPose pose_at(double milliseconds, double x) {
  TimedPose pose;
  pose.time = at(milliseconds);
  pose.pose.translation().x() = x;
  return pose;
}

/// The input of a binder, and the truth about it.
struct SyntheticScan {
  std::vector<TimedPose> poses;
  std::vector<Pulse> pulses;
  std::vector<Frame> frames;
  std::vector<Run> runs;            // announced before the scan
  std::vector<std::int64_t> truth;  //!< index of each frame's pulse; -1: none

  void add_pulse(double milliseconds, std::uint32_t arming = 1) {
    const bool same = !pulses.empty() && pulses.back().arming == arming;
    pulses.push_back({at(milliseconds), arming, same ? pulses.back().count + 1 : 1, 1});
  }

  /// A frame of the pulse with this index.
  void add_frame(std::size_t pulse, std::uint64_t counter, double latency = 4,
                 std::uint32_t acquisition = 1) {
    const auto late = static_cast<Nanoseconds>(latency * kMillisecond);
    frames.push_back({acquisition, counter, pulses[pulse].time + late, ""});
    truth.push_back(static_cast<std::int64_t>(pulse));
  }
};

/// Pulses every `period` [ms], a frame of each with counters from 101, and poses every 2 ms around
/// them.
inline SyntheticScan steady_scan(std::size_t pulses, double period = 10) {
  SyntheticScan scan;
  for (std::size_t i = 0; i < pulses; ++i) {
    scan.add_pulse(static_cast<double>(i) * period);
    scan.add_frame(i, 101 + i);
  }
  constexpr double kPoseInterval = 2;
  const double end = static_cast<double>(pulses) * period + 100;
  for (double t = -101; t < end; t += kPoseInterval)
    scan.poses.push_back(pose_at(t, t / 1000));
  return scan;
}

/// A scan whose lasers take turns, starting with laser_0. The first `slow` intervals are twice as
/// long; the trigger sends 4 of them.
inline SyntheticScan alternating_scan(std::size_t pulses, double period = 10,
                                      std::size_t slow = 4) {
  SyntheticScan scan = steady_scan(pulses + slow, period);
  scan.pulses.clear();
  scan.frames.clear();
  scan.truth.clear();
  for (std::size_t i = 0; i < pulses; ++i) {
    scan.add_pulse(static_cast<double>(i + std::min(i, slow)) * period);
    scan.pulses.back().lasers = i % 2 == 0 ? 1 : 2;
    scan.add_frame(i, 101 + i);
  }
  return scan;
}

/// 30 pulses, and 30 of a second arming from 1003 ms on, whose frames continue the counter; no
/// poses in between.
inline SyntheticScan armed_twice() {
  SyntheticScan scan = steady_scan(30);
  for (int i = 0; i < 30; ++i) {
    scan.add_pulse(1003 + 10.0 * i, 2);
    scan.add_frame(scan.pulses.size() - 1, static_cast<std::uint64_t>(131 + i));
  }
  return scan;
}

/// The output of a binder.
struct Outcome {
  std::vector<Decision> decisions;
  Audit audit;

  /// Number of frames dropped for this reason.
  std::size_t dropped(DropReason reason) const {
    return static_cast<std::size_t>(
        std::count_if(audit.dropped.begin(), audit.dropped.end(),
                      [reason](const Drop& drop) { return drop.reason == reason; }));
  }
  /// The frame's match, if it has one.
  std::optional<Match> match(std::size_t frame) const {
    for (const Decision& decision : decisions)
      if (decision.frame == frame) return decision.match;
    return std::nullopt;
  }
};

inline void collect(Binder& binder, Outcome& outcome) {
  for (Decision& decision : binder.take_decisions())
    outcome.decisions.push_back(std::move(decision));
}

/// Feeds a scan; the kind that comes next is drawn at random with these weights.
inline Outcome run(const SyntheticScan& scan, const Settings& settings, unsigned seed = 0,
                   std::array<double, 3> weights = {1, 1, 1}) {
  Binder binder(settings);
  for (const Run& told : scan.runs)
    binder.start_run(told);
  Outcome outcome;
  std::mt19937 random(seed);
  std::size_t pose = 0, pulse = 0, frame = 0;
  while (pose < scan.poses.size() || pulse < scan.pulses.size() || frame < scan.frames.size()) {
    std::discrete_distribution<int> kind({pose < scan.poses.size() ? weights[0] : 0,
                                          pulse < scan.pulses.size() ? weights[1] : 0,
                                          frame < scan.frames.size() ? weights[2] : 0});
    switch (kind(random)) {
      case 0:
        binder.add_pose(scan.poses[pose++]);
        break;
      case 1:
        binder.add_pulse(scan.pulses[pulse++]);
        break;
      default:
        binder.add_frame(scan.frames[frame++]);
    }
    collect(binder, outcome);
  }
  binder.end();
  collect(binder, outcome);
  outcome.audit = binder.audit();
  return outcome;
}

}  // namespace pose_frame_binder
