// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_frame_binder/frame_matcher.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pose_frame_binder {
namespace {

/// Frames held at most until enough of them agree; then they are dropped.
constexpr std::size_t kMostHeld = 64;

std::string milliseconds(Nanoseconds time) {
  constexpr double kPerMillisecond = 1e6;
  char text[32];
  std::snprintf(text, sizeof(text), "%.3f ms", static_cast<double>(time) / kPerMillisecond);
  return text;
}

}  // namespace

FrameMatcher::FrameMatcher(const PulseLog& pulses, const Settings& settings)
    : pulses_(pulses),
      settings_(settings),
      margin_(static_cast<std::size_t>(settings.frames_to_agree) - 1),
      tolerance_(scan_cell_common::from_seconds(settings.latency_tolerance)),
      latency_(scan_cell_common::from_seconds(settings.camera_latency)) {}

void FrameMatcher::add(std::size_t number, const Frame& frame) {
  queue_.push_back({number, frame});
}

double FrameMatcher::latency() const {
  return latency_measured_ ? scan_cell_common::to_seconds(latency_)
                           : std::numeric_limits<double>::quiet_NaN();
}

std::vector<FrameMatcher::Result> FrameMatcher::advance() {
  while (!queue_.empty() && pulses_.settled(queue_.front().frame.stamp - latency_)) {
    take(queue_.front());
    queue_.pop_front();
  }
  const bool last = !unconfirmed_.empty() && unconfirmed_.back().pulse + 1 == pulses_.size();
  if (pulses_.ended() && last)
    release(unconfirmed_.size());  // no frame can come that would confirm them
  return std::exchange(results_, {});
}

std::vector<FrameMatcher::Result> FrameMatcher::finish() {
  results_ = advance();
  elect_from_few();
  flush();
  if (doubted_) drop_unconfirmed("the frames after it do not agree");
  release(unconfirmed_.size());
  return std::exchange(results_, {});
}

void FrameMatcher::take(const Entry& entry) {
  const Frame& frame = entry.frame;
  if (frame.acquisition < acquisition_) {
    drop(entry, DropReason::OutOfOrder, "the camera was started again since");
    return;
  }
  if (frame.acquisition > acquisition_) {
    elect_from_few();
    flush();
    drop_unconfirmed("before the camera was started again");
    begin_acquisition(frame.acquisition);
  }
  const bool usable = frame.corrupt.empty();
  if (held_.empty() && (agrees(frame) || is_behind(frame) || (offset_ && !usable))) {
    judge(entry);
    return;
  }
  held_.push_back(entry);
  if (usable) vote(frame);
  if (held_.size() > kMostHeld) flush();
}

void FrameMatcher::begin_acquisition(std::uint32_t acquisition) {
  drop_next_ = acquisition_ == 0 ? 0 : margin_;
  acquisition_ = acquisition;
  offset_.reset();
  last_counter_.reset();
  gaps_.clear();
}

PulseLog::Place FrameMatcher::locate(const Frame& frame) const {
  return pulses_.locate(frame.stamp - latency_, tolerance_);
}

std::optional<std::size_t> FrameMatcher::pulse_of(const Frame& frame) const {
  if (!offset_) return std::nullopt;
  const PulseLog::Place place = locate(frame);
  const auto count = static_cast<std::int64_t>(frame.counter) - offset_->value;
  if (!place.pulse || pulses_.find(offset_->run, count) != place.pulse) return std::nullopt;
  return place.pulse;
}

bool FrameMatcher::agrees(const Frame& frame) const {
  const std::optional<std::size_t> pulse = pulse_of(frame);
  return pulse && !is_behind(frame) && (!last_pulse_ || *pulse > *last_pulse_);
}

bool FrameMatcher::is_behind(const Frame& frame) const {
  return last_counter_ && frame.counter <= *last_counter_;
}

void FrameMatcher::vote(const Frame& frame) {
  const PulseLog::Place place = locate(frame);
  if (!place.pulse || is_behind(frame)) return;
  const auto count = static_cast<std::int64_t>(pulses_[*place.pulse].count);
  const Offset offset = {pulses_.run(*place.pulse),
                         static_cast<std::int64_t>(frame.counter) - count};
  Votes& votes = votes_[offset];
  if (!votes.distances.empty() && frame.counter <= votes.last_counter) return;
  if (votes.distances.empty()) votes.first_count = count;
  votes.distances.push_back(place.distance);
  votes.last_counter = frame.counter;
  if (votes.distances.size() >= static_cast<std::size_t>(settings_.frames_to_agree)) {
    elect(offset, votes);
  }
}

void FrameMatcher::elect(const Offset& offset, Votes votes) {
  disputed_ = offset_ ? follow(offset) != offset : votes_.size() > 1;
  if (offset_ && disputed_) {
    slips_ += offset_->run == offset.run;
    drop_next_ = margin_;
    drop_unconfirmed("before the counter slipped");
  }
  offset_ = offset;
  if (!latency_measured_) {
    std::vector<Nanoseconds>& distances = votes.distances;
    std::sort(distances.begin(), distances.end());
    latency_ += distances[distances.size() / 2];
    latency_measured_ = true;
  }
  flush();
  disputed_ = false;
}

FrameMatcher::Offset FrameMatcher::follow(const Offset& next) const {
  Offset expected = *offset_;
  for (; expected.run < next.run; ++expected.run)
    expected.value += static_cast<std::int64_t>(pulses_.last_count(expected.run));
  return expected;
}

void FrameMatcher::elect_from_few() {
  if (votes_.size() != 1) return;
  const auto& [offset, votes] = *votes_.begin();
  const auto usable = std::count_if(held_.begin(), held_.end(),
                                    [](const Entry& e) { return e.frame.corrupt.empty(); });
  const bool unanimous = votes.distances.size() == static_cast<std::size_t>(usable);
  const bool new_run = !offset_ || offset_->run != offset.run;
  if (unanimous && new_run && votes.first_count == 1) elect(offset, votes);
}

void FrameMatcher::flush() {
  votes_.clear();
  for (const Entry& entry : std::exchange(held_, {}))
    judge(entry);
}

void FrameMatcher::judge(const Entry& entry) {
  const Frame& frame = entry.frame;
  if (!frame.corrupt.empty()) {
    drop(entry, DropReason::Corrupt, frame.corrupt);
  } else if (is_behind(frame)) {
    const bool repeated = !take_out_of_gap(frame.counter);
    drop(entry, repeated ? DropReason::Repeated : DropReason::OutOfOrder,
         "came after frame " + std::to_string(*last_counter_));
  } else if (agrees(frame)) {
    accept(entry);
  } else {
    refuse(entry);
  }
}

void FrameMatcher::accept(const Entry& entry) {
  const std::uint64_t counter = entry.frame.counter;
  const std::uint64_t expected = last_counter_ ? *last_counter_ + 1 : 0;
  if (counter > expected) gaps_[expected] = counter - 1;
  last_counter_ = counter;
  const PulseLog::Place place = locate(entry.frame);
  last_pulse_ = place.pulse;
  constexpr Nanoseconds kMemory = 10;  // frames over which the latency is followed
  latency_ += place.distance / kMemory;
  doubted_ = false;
  unconfirmed_.push_back({entry.number, counter, *place.pulse});
  if (drop_next_ > 0) {
    --drop_next_;
    drop_unconfirmed("after the counter slipped, or the camera was started again");
  } else if (unconfirmed_.size() > margin_) {
    release(unconfirmed_.size() - margin_);
  }
}

void FrameMatcher::release(std::size_t count) {
  for (; count > 0; --count) {
    const Unconfirmed& frame = unconfirmed_.front();
    results_.push_back({frame.number, frame.pulse, std::nullopt});
    unconfirmed_.pop_front();
  }
}

void FrameMatcher::drop_unconfirmed(const std::string& detail) {
  for (const Unconfirmed& frame : std::exchange(unconfirmed_, {})) {
    results_.push_back({frame.number, frame.pulse,
                        Drop{DropReason::CounterSlip, frame.number, frame.counter,
                             pulses_[frame.pulse].count, detail}});
  }
}

void FrameMatcher::refuse(const Entry& entry) {
  const PulseLog::Place place = locate(entry.frame);
  if (!place.pulse) {
    drop(entry, DropReason::NoTrigger,
         "no pulse at its stamp less the latency of " + milliseconds(latency_));
    return;
  }
  doubted_ = true;
  if (disputed_) {
    drop_next_ = margin_;
    drop_unconfirmed("next to a frame that does not agree, where the counter slipped");
  }
  std::string detail = "its stamp gives pulse " + std::to_string(pulses_[*place.pulse].count);
  detail +=
      offset_ ? ", its counter pulse " +
                    std::to_string(static_cast<std::int64_t>(entry.frame.counter) - offset_->value)
              : ", and too few frames agree on the counter's offset";
  drop(entry, DropReason::CounterSlip, detail);
}

bool FrameMatcher::take_out_of_gap(std::uint64_t counter) {
  auto gap = gaps_.upper_bound(counter);
  if (gap == gaps_.begin()) return false;
  --gap;
  const auto [first, last] = *gap;
  if (counter > last) return false;
  gaps_.erase(gap);
  if (first < counter) gaps_[first] = counter - 1;
  if (counter < last) gaps_[counter + 1] = last;
  return true;
}

void FrameMatcher::drop(const Entry& entry, DropReason reason, const std::string& detail) {
  Result result;
  result.frame = entry.number;
  result.pulse = pulse_of(entry.frame);
  const std::uint64_t count = result.pulse ? pulses_[*result.pulse].count : 0;
  result.drop = Drop{reason, entry.number, entry.frame.counter, count, detail};
  results_.push_back(result);
}

}  // namespace pose_frame_binder
