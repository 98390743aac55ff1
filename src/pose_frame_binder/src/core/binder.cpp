// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_frame_binder/binder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scan_cell_common/errors.h"

namespace pose_frame_binder {

using scan_cell_common::from_seconds;

const char* name(DropReason reason) {
  switch (reason) {
    case DropReason::NoTrigger:
      return "no_trigger";
    case DropReason::NoPoseBefore:
      return "no_pose_before";
    case DropReason::NoPoseAfter:
      return "no_pose_after";
    case DropReason::PoseGap:
      return "pose_gap";
    case DropReason::SharedPose:
      return "shared_pose";
    case DropReason::Repeated:
      return "repeated";
    case DropReason::OutOfOrder:
      return "out_of_order";
    case DropReason::Corrupt:
      return "corrupt";
    case DropReason::NeverArrived:
      return "never_arrived";
    case DropReason::CounterSlip:
      return "counter_slip";
  }
  return "unknown";
}

void check(const Settings& settings) {
  const auto in = [](const char* name, double value, double least, double most) {
    if (value >= least && value <= most) return;
    throw scan_cell_common::InvalidParameter(
        name, std::to_string(value),
        "give " + std::to_string(least) + " .. " + std::to_string(most));
  };
  constexpr double kLeast = 1e-6, kMost = 1e6;
  in("most_pose_gap", settings.most_pose_gap, kLeast, kMost);
  in("pose_settle", settings.pose_settle, 0, kMost);
  in("pose_delay", settings.pose_delay, -kMost, kMost);
  in("camera_latency", settings.camera_latency, -kMost, kMost);
  in("latency_tolerance", settings.latency_tolerance, kLeast, kMost);
  in("frames_to_agree", settings.frames_to_agree, 2, kMost);
  in("most_acceleration", settings.most_acceleration, 0, kMost);
  in("most_speed", settings.most_speed, 0, kMost);
  if (settings.method == Method::ConstantSpeed) check(settings.constant_speed);
}

Binder::Binder(const Settings& settings)
    : settings_((check(settings), settings)),
      rule_(make_pose_rule(settings)),
      poses_(from_seconds(settings.pose_settle), settings.most_poses),
      matcher_(pulses_, settings) {
  counts_.method = settings.method;
}

void Binder::add_pose(const TimedPose& pose) {
  TimedPose measured = pose;
  measured.time -= from_seconds(settings_.pose_delay);
  poses_.add(measured);
  bind();
}

void Binder::add_pulse(const Pulse& pulse) {
  pulses_.add(pulse);
  fates_.resize(pulses_.size(), Fate::Unknown);
  advance();
}

std::size_t Binder::add_frame(const Frame& frame) {
  if (matcher_.waiting() + pending_.size() >= settings_.most_pending_frames) {
    throw scan_cell_common::Refused(
        "frames waiting for pulses and poses", std::to_string(settings_.most_pending_frames),
        "check that trigger events and poses arrive, or raise most_pending_frames");
  }
  const std::size_t number = counters_.size();
  counters_.push_back(frame.counter);
  matcher_.add(number, frame);
  advance();
  return number;
}

void Binder::end_pulses() {
  pulses_.end();
  advance();
}

void Binder::end(std::uint64_t triggers) {
  triggers_ = triggers;
  pulses_.end();
  poses_.end();
  for (const FrameMatcher::Result& result : matcher_.finish())
    take(result);
  bind();
}

std::vector<Decision> Binder::take_decisions() {
  return std::exchange(decisions_, {});
}

bool Binder::whole(std::uint64_t triggers) const {
  return pulses_.size() >= triggers && settled_ == pulses_.size() && matcher_.waiting() == 0;
}

void Binder::advance() {
  for (const FrameMatcher::Result& result : matcher_.advance())
    take(result);
  bind();
}

void Binder::take(const FrameMatcher::Result& result) {
  if (!result.drop) {
    pending_.push_back({result.frame, *result.pulse});
    return;
  }
  dropped_.push_back(*result.drop);
  decisions_.push_back({result.frame, std::nullopt});
  if (result.pulse) settle(*result.pulse, Fate::Dropped);
}

void Binder::bind() {
  while (!pending_.empty()) {
    const auto [frame, pulse] = pending_.front();
    const std::optional<PoseAnswer> answer = rule_->find(pulse, pulses_, poses_);
    if (!answer) return;
    pending_.pop_front();
    decisions_.push_back({frame, answer->match});
    if (!answer->match) {
      dropped_.push_back(
          {answer->reason, frame, counters_[frame], pulses_[pulse].count, answer->detail});
      settle(pulse, Fate::Dropped);
      continue;
    }
    settle(pulse, Fate::Bound);
    const Match& match = *answer->match;
    ++counts_.frames_bound;
    ++counts_.by_rule[static_cast<int>(match.rule)];
    // The nearest pose that was used; fmin passes over the one that was not.
    counts_.worst_time_to_pose =
        std::max(counts_.worst_time_to_pose, std::fmin(match.time_to_before, match.time_to_after));
    counts_.worst_position_error =
        std::max(counts_.worst_position_error, match.position_error_bound);
  }
}

void Binder::settle(std::size_t pulse, Fate fate) {
  if (fates_[pulse] == Fate::Unknown) ++settled_;
  fates_[pulse] = std::max(fates_[pulse], fate);
}

bool Binder::latency_doubtful() const {
  if (fates_.empty() || counts_.frames_bound == 0) return false;
  const auto without_pulse = [this](std::size_t frame) {
    return std::any_of(dropped_.begin(), dropped_.end(), [frame](const Drop& drop) {
      return drop.frame == frame && drop.reason == DropReason::NoTrigger;
    });
  };
  return (fates_.front() == Fate::Unknown && without_pulse(counters_.size() - 1)) ||
         (fates_.back() == Fate::Unknown && without_pulse(0));
}

Audit Binder::counts() const {
  Audit audit = counts_;
  audit.triggers = std::max<std::uint64_t>(triggers_, pulses_.size());
  audit.triggers_missing = audit.triggers - pulses_.size();
  audit.triggers_refused = pulses_.refused();
  audit.frames = counters_.size();
  audit.poses = poses_.size();
  audit.frames_dropped = dropped_.size();
  audit.latency = matcher_.latency();
  audit.slips = matcher_.slips();
  audit.poses_repeated = poses_.repeated();
  audit.poses_late = poses_.late();
  audit.poses_unusable = poses_.unusable();
  return audit;
}

Audit Binder::audit() const {
  Audit audit = counts();
  audit.latency_doubtful = latency_doubtful();
  audit.dropped = dropped_;
  std::stable_sort(audit.dropped.begin(), audit.dropped.end(),
                   [](const Drop& a, const Drop& b) { return a.frame < b.frame; });
  for (std::size_t i = 0; i < fates_.size(); ++i) {
    if (fates_[i] != Fate::Unknown) continue;
    ++audit.frames_never_arrived;
    audit.dropped.push_back({DropReason::NeverArrived, std::nullopt, 0, pulses_[i].count,
                             "arming " + std::to_string(pulses_[i].arming)});
  }
  return audit;
}

}  // namespace pose_frame_binder
