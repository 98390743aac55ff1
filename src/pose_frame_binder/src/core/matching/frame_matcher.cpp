// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/frame_matcher.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace pose_frame_binder {
namespace {

/// Most frames held until enough of them agree; beyond it they are dropped.
constexpr std::size_t kMaxHeld = 64;  // chosen

/// Most frames that wait for proof of the latency; beyond it the oldest are dropped.
constexpr std::size_t kMaxUnproved = 64;

constexpr const char* kUnproved =
    "it may belong to the pulse before or after, which had the other laser on: no change of the "
    "pulse interval has proved the latency";

std::string milliseconds(Nanoseconds time) {
  constexpr double kPerMillisecond = 1e6;  // [ns]
  return fmt::format("{:.3f} ms", static_cast<double>(time) / kPerMillisecond);
}

}  // namespace

FrameMatcher::FrameMatcher(const PulseLog& pulses, FrameLog& frames, const Settings& settings)
    : pulses_(pulses),
      frames_(frames),
      settings_(settings),
      margin_(static_cast<std::size_t>(settings.frames_to_agree) - 1),
      tolerance_(scan_cell_common::from_seconds(settings.latency_tolerance)),
      initial_latency_(scan_cell_common::from_seconds(settings.camera_latency)),
      proof_(pulses, margin_) {}

double FrameMatcher::latency() const {
  return latency_ ? scan_cell_common::to_seconds(*latency_)
                  : std::numeric_limits<double>::quiet_NaN();
}

void FrameMatcher::advance() {
  while (next_ < frames_.end() && pulses_.settled(frames_[next_].frame.stamp - expected_latency()))
    take(frames_[next_++]);
  const bool last = last_pulse_ && *last_pulse_ + 1 == pulses_.size();
  // No further frame can confirm them.
  if (pulses_.ended() && last) confirm_all();
}

void FrameMatcher::finish() {
  advance();
  elect_from_few();
  judge_held(false);
  if (last_judged_disagreed()) drop_unconfirmed("the frames after it do not agree");
  confirm_all();
}

void FrameMatcher::take(FrameRecord& record) {
  const Frame& frame = record.frame;
  if (frame.acquisition < acquisition_) {
    drop(record, DropReason::kOutOfOrder, "the camera has been restarted since");
    return;
  }
  if (frame.acquisition > acquisition_) {
    elect_from_few();
    judge_held(false);
    drop_unconfirmed("before the camera was restarted");
    begin_acquisition(frame.acquisition);
  }
  const bool usable = frame.corrupt.empty();
  const bool none_held = frames_.count(FrameState::kHeld) == 0;
  if (none_held && (agrees(frame) || is_behind(frame) || (offset_ && !usable))) {
    judge(record, false);
    return;
  }
  if (none_held) first_held_ = record.number;
  frames_.set(record, FrameState::kHeld);
  if (usable) vote(frame);
  if (frames_.count(FrameState::kHeld) > kMaxHeld) judge_held(false);
}

void FrameMatcher::begin_acquisition(std::uint32_t acquisition) {
  drop_next_ = acquisition_ == 0 ? 0 : margin_;
  acquisition_ = acquisition;
  offset_.reset();
  last_counter_.reset();
  gaps_.clear();
  settle_unproved();
  proof_.reset();  // the camera's clock has restarted
}

PulseLog::Place FrameMatcher::locate(const Frame& frame) const {
  return pulses_.locate(frame.stamp - expected_latency(), tolerance_);
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
  const bool disputed = offset_ ? follow(offset) != offset : votes_.size() > 1;
  if (offset_ && disputed) {
    slips_ += offset_->run == offset.run;
    drop_next_ = margin_;
    drop_unconfirmed("before the counter slipped");
  }
  if (!proof_.holds() && (!offset_ || *offset_ != offset)) {
    if (disputed) settle_unproved();
    proof_.reset();
  }
  offset_ = offset;
  if (!latency_) {
    std::vector<Nanoseconds>& distances = votes.distances;
    std::sort(distances.begin(), distances.end());
    latency_ = initial_latency_ + distances[distances.size() / 2];
  }
  judge_held(disputed);
}

FrameMatcher::Offset FrameMatcher::follow(const Offset& next) const {
  Offset expected = *offset_;
  for (; expected.run < next.run; ++expected.run)
    expected.value += static_cast<std::int64_t>(pulses_.last_count(expected.run));
  return expected;
}

void FrameMatcher::elect_from_few() {
  if (votes_.size() != 1) return;
  const auto [offset, votes] = *votes_.begin();
  const bool unanimous = votes.distances.size() == usable_held();
  const bool new_run = !offset_ || offset_->run != offset.run;
  if (unanimous && new_run && votes.first_count == 1) elect(offset, votes);
}

std::size_t FrameMatcher::usable_held() const {
  std::size_t usable = 0;
  if (frames_.count(FrameState::kHeld) == 0) return usable;
  for (std::size_t number = first_held_; number < next_; ++number) {
    const FrameRecord& record = frames_[number];
    usable += record.state == FrameState::kHeld && record.frame.corrupt.empty();
  }
  return usable;
}

void FrameMatcher::judge_held(bool disputed) {
  votes_.clear();
  for (std::size_t number = first_held_; frames_.count(FrameState::kHeld) > 0; ++number) {
    if (frames_[number].state == FrameState::kHeld) judge(frames_[number], disputed);
  }
}

void FrameMatcher::judge(FrameRecord& record, bool disputed) {
  const Frame& frame = record.frame;
  if (!frame.corrupt.empty()) {
    drop(record, DropReason::kCorrupt, frame.corrupt);
  } else if (is_behind(frame)) {
    const bool repeated = !take_out_of_gap(frame.counter);
    drop(record, repeated ? DropReason::kRepeated : DropReason::kOutOfOrder,
         fmt::format("came after frame {}", *last_counter_));
  } else if (agrees(frame)) {
    accept(record);
  } else {
    refuse(record, disputed);
  }
}

void FrameMatcher::accept(FrameRecord& record) {
  const std::uint64_t counter = record.frame.counter;
  const std::uint64_t expected = last_counter_ ? *last_counter_ + 1 : 0;
  if (counter > expected) gaps_[expected] = counter - 1;
  last_counter_ = counter;
  const PulseLog::Place place = locate(record.frame);
  record.pulse = last_pulse_ = place.pulse;
  proof_.add(*place.pulse, place.distance);
  if (proof_.holds()) settle_unproved();
  constexpr Nanoseconds kMemory = 10;  // frames over which the latency is averaged
  *latency_ += place.distance / kMemory;
  if (frames_.count(FrameState::kAgreed) == 0) first_agreed_ = record.number;
  frames_.set(record, FrameState::kAgreed);
  if (drop_next_ > 0) {
    --drop_next_;
    drop_unconfirmed("after the counter slipped, or the camera was restarted");
  } else if (frames_.count(FrameState::kAgreed) > margin_) {
    confirm(frames_.count(FrameState::kAgreed) - margin_);
  }
}

void FrameMatcher::confirm(std::size_t count) {
  for (; count > 0; --count) {
    FrameRecord& record = first_agreed();
    const bool certain = proof_.holds() || !pulses_.lasers_vary(pulses_.run(*record.pulse));
    frames_.set(record, certain ? FrameState::kMatched : FrameState::kUnproved);
  }
  while (frames_.count(FrameState::kUnproved) > kMaxUnproved)
    frames_.drop(first_unproved(), DropReason::kLaserUncertain, kUnproved);
}

void FrameMatcher::confirm_all() {
  confirm(frames_.count(FrameState::kAgreed));
  settle_unproved();
}

void FrameMatcher::settle_unproved() {
  while (frames_.count(FrameState::kUnproved) > 0) {
    FrameRecord& record = first_unproved();
    if (proof_.holds()) {
      frames_.set(record, FrameState::kMatched);
    } else {
      frames_.drop(record, DropReason::kLaserUncertain, kUnproved);
    }
  }
}

void FrameMatcher::drop_unconfirmed(const std::string& detail) {
  while (frames_.count(FrameState::kAgreed) > 0)
    frames_.drop(first_agreed(), DropReason::kCounterSlip, detail);
}

FrameRecord& FrameMatcher::first_agreed() {
  return first_in(FrameState::kAgreed, first_agreed_);
}

FrameRecord& FrameMatcher::first_unproved() {
  return first_in(FrameState::kUnproved, first_unproved_);
}

FrameRecord& FrameMatcher::first_in(FrameState state, std::size_t& first) {
  first = std::max(first, frames_.first());
  while (frames_[first].state != state)
    ++first;
  return frames_[first];
}

bool FrameMatcher::last_judged_disagreed() const {
  for (std::size_t number = next_; number-- > frames_.first();) {
    const FrameRecord& record = frames_[number];
    if (record.state == FrameState::kAgreed) return false;
    if (record.state == FrameState::kDropped && record.reason == DropReason::kCounterSlip)
      return true;
  }
  return false;
}

void FrameMatcher::refuse(FrameRecord& record, bool disputed) {
  const PulseLog::Place place = locate(record.frame);
  if (!place.pulse) {
    drop(record, DropReason::kNoTrigger,
         "no pulse at its stamp minus the latency of " + milliseconds(expected_latency()));
    return;
  }
  if (disputed) {
    drop_next_ = margin_;
    drop_unconfirmed("next to a frame that does not agree: the counter slipped");
  }
  std::string detail = fmt::format("its stamp gives pulse {}", pulses_[*place.pulse].count);
  detail += offset_ ? fmt::format(", its counter pulse {}",
                                  static_cast<std::int64_t>(record.frame.counter) - offset_->value)
                    : ", and too few frames agree on the counter's offset";
  drop(record, DropReason::kCounterSlip, detail);
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

void FrameMatcher::drop(FrameRecord& record, DropReason reason, const std::string& detail) {
  record.pulse = pulse_of(record.frame);
  frames_.drop(record, reason, detail);
}

}  // namespace pose_frame_binder
