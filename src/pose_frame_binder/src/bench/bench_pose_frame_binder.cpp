// Copyright 2026 the scan cell developers SPDX-License-Identifier: BSD-3-Clause Counts wrong
// pairings in a million frames with faults, compared with simpler methods on the same frames.
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>

#include "faulty_scan.h"
#include "pose_frame_binder/binder.h"
#include "scan_cell_common/tools/tool_main.h"

using namespace pose_frame_binder;  // NOLINT

namespace {

constexpr std::size_t kPulses = 1'000'000;         // chosen
constexpr std::size_t kPosesAllowed = 10'000'000;  // chosen: more than the scan has

std::size_t memory_used() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

struct Run {
  std::vector<Decision> decisions;
  Audit audit;
  double seconds = 0;
  std::size_t memory = 0;  // [bytes] of the binder at the end
};

TimedPose to_pose(const FaultyPose& faulty) {
  TimedPose pose;
  pose.time = faulty.time;
  const double x = scan_cell_common::to_seconds(faulty.time - kScanStart);
  pose.pose.translation().x() = faulty.finite ? x : NAN;
  return pose;
}

/// Feeds all that the scan sends, in order of arrival.
Run bind(const FaultyScan& scan) {
  Settings settings;
  settings.max_poses = kPosesAllowed;
  Run run;
  run.decisions.reserve(scan.frames.size());
  const std::size_t before = memory_used();
  const auto begin = std::chrono::steady_clock::now();
  Binder binder(settings);
  std::size_t pose = 0, pulse = 0, frame = 0;
  constexpr Nanoseconds kNever = INT64_MAX;
  while (true) {
    const Nanoseconds of_pose = pose < scan.poses.size() ? scan.poses[pose].arrival : kNever;
    const Nanoseconds of_pulse = pulse < scan.pulses.size() ? scan.pulses[pulse].arrival : kNever;
    const Nanoseconds of_frame = frame < scan.frames.size() ? scan.frames[frame].arrival : kNever;
    const Nanoseconds next = std::min({of_pose, of_pulse, of_frame});
    if (next == kNever) break;
    if (next == of_pose) {
      binder.add_pose(to_pose(scan.poses[pose++]));
    } else if (next == of_pulse) {
      if (!scan.pulses[pulse].lost) binder.add_pulse(scan.pulses[pulse].pulse);
      ++pulse;
    } else {
      binder.add_frame(scan.frames[frame++].frame);
    }
    for (const Decision& decision : binder.take_decisions())
      run.decisions.push_back(decision);
  }
  binder.end(scan.pulses.size());
  for (const Decision& decision : binder.take_decisions())
    run.decisions.push_back(decision);
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run.memory = memory_used() - before;
  run.audit = binder.audit();
  return run;
}

bool is_right(const FaultyScan& scan, const Decision& decision) {
  constexpr double kExact = 1e-6;  // [m] at 1 m/s: a microsecond; chosen
  const std::int64_t truth = scan.frames[decision.frame].pulse;
  if (truth < 0) return false;
  const Pulse& pulse = scan.pulses[static_cast<std::size_t>(truth)].pulse;
  const double x = scan_cell_common::to_seconds(pulse.time - kScanStart);
  return decision.match->pulse.time == pulse.time &&
         std::abs(decision.match->pose.translation().x() - x) < kExact;
}

/// Counts frames bound to another laser than the one that was on during their exposure.
std::size_t count_wrong_lasers(const FaultyScan& scan, const Run& run) {
  std::size_t wrong = 0;
  for (const Decision& decision : run.decisions) {
    if (!decision.match) continue;
    const std::int64_t truth = scan.frames[decision.frame].pulse;
    const int lit = truth < 0 ? 0 : scan.pulses[static_cast<std::size_t>(truth)].pulse.lasers;
    wrong += 1 << decision.match->laser != lit;
  }
  return wrong;
}

/// Counts frames and pulses that the audit does not account for.
std::size_t count_unaccounted(const FaultyScan& scan, const Run& run) {
  const Audit& audit = run.audit;
  std::size_t wrong = 0;
  std::vector<char> decided(scan.frames.size());
  std::map<std::pair<std::uint32_t, std::uint64_t>, bool> bound;
  for (const Decision& decision : run.decisions) {
    wrong += decided[decision.frame]++ != 0;
    if (decision.match)
      wrong +=
          !bound.emplace(std::pair(decision.match->pulse.arming, decision.match->pulse.count), true)
               .second;
  }
  wrong += static_cast<std::size_t>(std::count(decided.begin(), decided.end(), 0));
  std::size_t dropped = 0, never = 0;
  for (const Drop& drop : audit.dropped)
    ++(drop.frame ? dropped : never);
  wrong += audit.frames != scan.frames.size();
  wrong += audit.frames != audit.frames_bound + audit.frames_dropped;
  wrong += audit.frames_bound != bound.size();
  wrong += audit.frames_dropped != dropped;
  wrong += audit.frames_never_arrived != never;
  const auto lost = std::count_if(scan.pulses.begin(), scan.pulses.end(),
                                  [](const FaultyPulse& pulse) { return pulse.lost; });
  wrong += audit.triggers != scan.pulses.size();
  wrong += audit.triggers_missing != static_cast<std::size_t>(lost);
  return wrong;
}

struct Plain {
  std::size_t by_counter = 0;  //!< wrong pairings
  std::size_t by_stamp = 0;
};

/// By counter: the offset from the first frame of each acquisition and arming, whose pulse is
/// given. By stamp: the pulse nearest to stamp - 4 ms. Neither uses a frame twice.
Plain pair_plainly(const FaultyScan& scan) {
  Plain wrong;
  std::pair<std::uint32_t, std::uint32_t> part{0, 0};
  std::int64_t offset = 0;
  std::int64_t last_counter = -1;
  for (const FaultyFrame& faulty : scan.frames) {
    const Frame& frame = faulty.frame;
    if (!frame.corrupt.empty() || faulty.pulse < 0) continue;
    const auto counter = static_cast<std::int64_t>(frame.counter);
    const auto& truth = scan.pulses[static_cast<std::size_t>(faulty.pulse)].pulse;
    const std::pair<std::uint32_t, std::uint32_t> now{frame.acquisition, truth.arming};
    if (now != part) {
      part = now;
      offset = counter - faulty.pulse;
      last_counter = -1;
    }
    if (counter > last_counter) {
      last_counter = counter;
      wrong.by_counter += counter - offset != faulty.pulse;
    }
    constexpr Nanoseconds kLatency = 4'000'000;  // [ns] that of the scan, without its drift
    const Nanoseconds instant = frame.stamp - kLatency;
    const auto after = std::lower_bound(
        scan.pulses.begin(), scan.pulses.end(), instant,
        [](const FaultyPulse& pulse, Nanoseconds t) { return pulse.pulse.time < t; });
    auto nearest = after == scan.pulses.end() ? after - 1 : after;
    if (nearest != scan.pulses.begin() &&
        instant - (nearest - 1)->pulse.time < std::abs(nearest->pulse.time - instant))
      --nearest;
    wrong.by_stamp += nearest - scan.pulses.begin() != faulty.pulse;
  }
  return wrong;
}

void bench_pairings(const char* name, const tecnogamma_camera::CounterRule& rule, unsigned seed) {
  const FaultyScan scan(kPulses, rule, {}, seed, false);
  const Run run = bind(scan);
  std::size_t wrong = 0, whole = 0;
  for (const Decision& decision : run.decisions) {
    wrong += decision.match && !is_right(scan, decision);
    const std::int64_t pulse = scan.frames[decision.frame].pulse;
    whole += decision.match && pulse >= 0 && !scan.faulty[static_cast<std::size_t>(pulse)];
  }
  const auto faulty = std::count(scan.faulty.begin(), scan.faulty.end(), true);
  const auto percent = [](auto part, auto all) {
    return 100.0 * static_cast<double>(part) / static_cast<double>(all);
  };
  const Plain plain = pair_plainly(scan);
  const Audit& audit = run.audit;
  constexpr double kMillion = 1e6;
  std::printf(
      "%s, %zu pulses, faults at %.1f %%, counter turned %zu times, %llu slips found: wrong "
      "pairings "
      "%zu (goal 0); by the counter alone %zu, by the stamp alone %zu\n",
      name, scan.pulses.size(), percent(faulty, kPulses), scan.turns,
      static_cast<unsigned long long>(audit.slips), wrong, plain.by_counter, plain.by_stamp);
  std::printf(
      "  %llu frames = %llu bound + %llu dropped, %llu never arrived, books out by %zu (goal 0); "
      "bound of the frames without a fault %.1f %%; %.2f million frames/s; binder's memory %.0f "
      "MB, "
      "%.0f bytes a frame\n",
      static_cast<unsigned long long>(audit.frames),
      static_cast<unsigned long long>(audit.frames_bound),
      static_cast<unsigned long long>(audit.frames_dropped),
      static_cast<unsigned long long>(audit.frames_never_arrived), count_unaccounted(scan, run),
      percent(whole, kPulses - static_cast<std::size_t>(faulty)),
      static_cast<double>(scan.frames.size()) / run.seconds / kMillion,
      static_cast<double>(run.memory) / kMillion,
      static_cast<double>(run.memory) / static_cast<double>(scan.frames.size()));
}

/// After each restart of the counter the latency must be proved again, by pulses that were left
/// out, and many frames are dropped until then. So this is also run without the faults that restart
/// it.
void bench_alternating(const tecnogamma_camera::CounterRule& rule, bool restarts, unsigned seed) {
  FaultShares shares;
  if (!restarts) shares.restart = shares.garbled_counter = shares.wrong_counter = 0;
  const FaultyScan scan(kPulses, rule, shares, seed, true);
  const Run run = bind(scan);
  std::printf(
      "alternating lasers, %zu pulses, %s restarts of the counter: wrong lasers %zu (goal "
      "0); %llu frames = %llu bound + %llu dropped, of these %llu of an uncertain laser; books out "
      "by %zu (goal 0)\n",
      scan.pulses.size(), restarts ? "with" : "without", count_wrong_lasers(scan, run),
      static_cast<unsigned long long>(run.audit.frames),
      static_cast<unsigned long long>(run.audit.frames_bound),
      static_cast<unsigned long long>(run.audit.frames_dropped),
      static_cast<unsigned long long>(run.audit.frames_laser_uncertain),
      count_unaccounted(scan, run));
}

}  // namespace

int main(int argc, char** argv) {
  unsigned seed = 1;
  CLI::App app("Wrong pairings and speed of the binder on faulty scans, beside plain pairing");
  app.add_option("seed", seed, "of the faults")->capture_default_str();
  return scan_cell_common::tool_main("bench_pose_frame_binder", app, argc, argv, [&] {
    bench_pairings("16-bit counter", tecnogamma_camera::kCounter16, seed);
    bench_pairings("GigE Vision block id", tecnogamma_camera::kGigEVisionBlockId, seed + 1);
    bench_pairings("24-bit counter", tecnogamma_camera::kCounter24, seed + 2);
    bench_alternating(tecnogamma_camera::kGigEVisionBlockId, true, seed + 3);
    bench_alternating(tecnogamma_camera::kGigEVisionBlockId, false, seed + 4);
    return 0;
  });
}
