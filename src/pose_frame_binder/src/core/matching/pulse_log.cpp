// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/pulse_log.h"

#include <algorithm>
#include <utility>

namespace pose_frame_binder {

void PulseLog::add(const Pulse& pulse) {
  std::uint32_t run = 0;
  if (!entries_.empty()) {
    const Entry& last = entries_.back();
    if (ended_ || pulse.time <= last.pulse.time) {
      ++refused_;
      return;
    }
    const bool goes_on = pulse.arming == last.pulse.arming && pulse.count > last.pulse.count;
    run = goes_on ? last.run : last.run + 1;
  }
  entries_.push_back({pulse, run});
  if (run == runs_.size()) runs_.push_back({pulse.lasers, false});
  runs_[run].vary = runs_[run].vary || pulse.lasers != runs_[run].lasers;
}

std::optional<std::size_t> PulseLog::find(std::uint32_t run, std::int64_t count) const {
  if (count < 1) return std::nullopt;
  const auto key = std::make_pair(run, static_cast<std::uint64_t>(count));
  const auto before = [](const Entry& entry, const std::pair<std::uint32_t, std::uint64_t>& k) {
    return std::make_pair(entry.run, entry.pulse.count) < k;
  };
  const auto found = std::lower_bound(entries_.begin(), entries_.end(), key, before);
  if (found == entries_.end() || found->run != run || found->pulse.count != key.second) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(found - entries_.begin());
}

std::size_t PulseLog::first_of(std::uint32_t run) const {
  const auto before = [](const Entry& entry, std::uint32_t r) { return entry.run < r; };
  const auto first = std::lower_bound(entries_.begin(), entries_.end(), run, before);
  return static_cast<std::size_t>(first - entries_.begin());
}

std::uint64_t PulseLog::last_count(std::uint32_t run) const {
  const auto before = [](std::uint32_t r, const Entry& entry) { return r < entry.run; };
  const auto next = std::upper_bound(entries_.begin(), entries_.end(), run, before);
  return next == entries_.begin() || (next - 1)->run != run ? 0 : (next - 1)->pulse.count;
}

std::size_t PulseLog::first_after(Nanoseconds time) const {
  const auto after = [](Nanoseconds t, const Entry& entry) { return t < entry.pulse.time; };
  const auto found = std::upper_bound(entries_.begin(), entries_.end(), time, after);
  return static_cast<std::size_t>(found - entries_.begin());
}

bool PulseLog::settled(Nanoseconds time) const {
  if (ended_) return true;
  const std::size_t after = first_after(time);
  if (after == entries_.size()) return false;
  const bool nearer_left =
      after > 0 && time - entries_[after - 1].pulse.time < entries_[after].pulse.time - time;
  return nearer_left || after + 1 < entries_.size();
}

PulseLog::Place PulseLog::locate(Nanoseconds time, Nanoseconds tolerance) const {
  if (entries_.empty()) return {};
  // The interval around `time`; before the first and after the last pulse, the nearest interval.
  const std::size_t after = std::clamp<std::size_t>(first_after(time), 1, entries_.size());
  const std::size_t right = std::min(after, entries_.size() - 1);
  const std::size_t left = right == 0 ? 0 : right - 1;
  const Nanoseconds interval = entries_[right].pulse.time - entries_[left].pulse.time;
  constexpr Nanoseconds kMaxPercent = 45;  // of the interval, so never two pulses; chosen
  if (interval > 0) tolerance = std::min(tolerance, interval * kMaxPercent / 100);

  const Nanoseconds from_left = time - entries_[left].pulse.time;
  const Nanoseconds from_right = time - entries_[right].pulse.time;
  const bool nearer_left = std::abs(from_left) < std::abs(from_right);
  const Nanoseconds distance = nearer_left ? from_left : from_right;
  if (std::abs(distance) > tolerance) return {};
  return {nearer_left ? left : right, distance};
}

}  // namespace pose_frame_binder
