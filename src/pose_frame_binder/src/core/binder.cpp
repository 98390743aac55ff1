// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_frame_binder/binder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "frames/frame_log.h"
#include "matching/frame_matcher.h"
#include "matching/laser_choice.h"
#include "matching/pulse_log.h"
#include "poses/pose_log.h"
#include "poses/pose_rule.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace pose_frame_binder {

using scan_cell_common::from_seconds;

const char* name(DropReason reason) {
  static constexpr const char* kNames[] = {"no_trigger",   "no_pose_before", "no_pose_after",
                                           "pose_gap",     "shared_pose",    "repeated",
                                           "out_of_order", "corrupt",        "never_arrived",
                                           "counter_slip", "laser_uncertain"};
  const auto index = static_cast<std::size_t>(reason) - 1;
  return index < std::size(kNames) ? kNames[index] : "unknown";
}

void describe(scan_cell_common::ParameterTable& table, Settings& settings) {
  static const std::vector<std::string> kMethods = {"first_pose", "interpolate", "constant_speed"};
  std::string method = kMethods.at(static_cast<std::size_t>(settings.method) - 1);
  table.choice("method", method, kMethods, "how a pulse gets its pose");
  const auto found = std::find(kMethods.begin(), kMethods.end(), method) - kMethods.begin();
  settings.method = static_cast<Method>(found + 1);
  table.add("max_pose_gap", settings.max_pose_gap, {1e-4, 10, "s"},
            "longest time between the poses around a pulse; for `first_pose`, from the pulse to "
            "its pose");
  table.renamed("most_pose_gap", "max_pose_gap");
  table.add("pose_settle", settings.pose_settle, {0, 1, "s"},
            "a pose further behind the newest is dropped as late; also how long a match waits for "
            "poses out of order");
  table.add("pose_delay", settings.pose_delay, {-1, 1, "s"},
            "how much too late the poses are stamped, as found by estimate_time_offset; subtracted "
            "from each stamp");
  table.add("camera_latency", settings.camera_latency, {-0.1, 1, "s"},
            "expected time from a pulse to the stamp of its frame");
  table.add("latency_tolerance", settings.latency_tolerance, {1e-5, 1, "s"},
            "largest deviation from the latency; 0.45 of the pulse interval if that is less");
  table.add("frames_to_agree", settings.frames_to_agree, {2, 32},
            "how many frames must agree on the counter's offset; one fewer are held back before "
            "they are published, and dropped on either side of a slip");
  table.add("max_acceleration", settings.max_acceleration, {0.01, 1000, "m/s^2"},
            "of the flange, for the error bound");
  table.renamed("most_acceleration", "max_acceleration");
  table.add("max_speed", settings.max_speed, {0.001, 100, "m/s"},
            "of the flange, for the error bound");
  table.renamed("most_speed", "max_speed");
  table.add(
      "max_poses", settings.max_poses, {100, 1e9},
      "most poses of a scan in memory (170 bytes each; 2,000,000 are over an hour at 500 Hz)");
  table.renamed("most_poses", "max_poses");
  table.add("max_pending_frames", settings.max_pending_frames, {10, 1e7},
            "most frames that may wait for pulses or poses");
  table.renamed("most_pending_frames", "max_pending_frames");
}

void check(const Settings& settings) {
  scan_cell_common::check(settings);
  if (settings.method == Method::kConstantSpeed && is_given(settings.constant_speed))
    check(settings.constant_speed);
}

Binder::Binder(const Settings& settings)
    : settings_((check(settings), settings)),
      rule_(make_pose_rule(settings)),
      poses_(std::make_unique<PoseLog>(from_seconds(settings.pose_settle), settings.max_poses)),
      pulses_(std::make_unique<PulseLog>()),
      frames_(std::make_unique<FrameLog>(
          [this](const FrameRecord& frame, const std::string& detail) { on_drop(frame, detail); })),
      matcher_(std::make_unique<FrameMatcher>(*pulses_, *frames_, settings)) {
  counts_.method = settings.method;
}

Binder::~Binder() = default;

std::uint64_t Binder::pulses() const {
  return pulses_->size();
}

std::uint64_t Binder::progress() const {
  return pulses() + settled_ + frames_->undecided();
}

void Binder::start_run(const Run& run) {
  check(run, settings_);
  if (settings_.method == Method::kConstantSpeed && is_given(settings_.constant_speed) &&
      !passes_.empty()) {
    throw scan_cell_common::Refused(
        "second arming of the trigger",
        "the parameters constant_speed/* describe the motion of the first arming only",
        "remove them (scan_cell gives the motion of each line), or scan once along one line");
  }
  rule_->start_run(run.motion);
  passes_.push_back(run.pass);
}

std::uint32_t Binder::pass_of(std::size_t pulse) const {
  const std::uint32_t run = pulses_->run(pulse);
  return run < passes_.size() ? passes_[run] : run;
}

void Binder::add_pose(const TimedPose& pose) {
  TimedPose measured = pose;
  measured.time -= from_seconds(settings_.pose_delay);
  poses_->add(measured);
  bind();
}

void Binder::add_pulse(const Pulse& pulse) {
  pulses_->add(pulse);
  fates_.resize(pulses_->size(), Fate::kUnknown);
  advance();
  if (pulses_->size() > 0) rule_->check_told(pulses_->run(pulses_->size() - 1));
}

std::size_t Binder::add_frame(const Frame& frame) {
  if (frames_->undecided() >= settings_.max_pending_frames) {
    throw scan_cell_common::Refused(
        "frames waiting for pulses and poses", fmt::format("{}", settings_.max_pending_frames),
        "check that trigger events and poses arrive, or raise max_pending_frames");
  }
  const std::size_t number = frames_->add(frame);
  advance();
  return number;
}

void Binder::end_pulses() {
  pulses_->end();
  advance();
}

void Binder::end(std::uint64_t triggers) {
  triggers_ = triggers;
  pulses_->end();
  poses_->end();
  matcher_->finish();
  bind();
}

std::vector<Decision> Binder::take_decisions() {
  return std::exchange(decisions_, {});
}

bool Binder::whole(std::uint64_t triggers) const {
  return pulses_->size() >= triggers && settled_ == pulses_->size() &&
         frames_->undecided() == frames_->count(FrameState::kMatched);
}

void Binder::advance() {
  matcher_->advance();
  bind();
}

void Binder::on_drop(const FrameRecord& frame, const std::string& detail) {
  const Pulse pulse = frame.pulse ? (*pulses_)[*frame.pulse] : Pulse();
  dropped_.push_back(
      {frame.reason, frame.number, frame.frame.counter, pulse.arming, pulse.count, detail});
  decisions_.push_back({frame.number, std::nullopt});
  counts_.frames_laser_uncertain += frame.reason == DropReason::kLaserUncertain;
  if (frame.pulse) settle(*frame.pulse, Fate::kDropped);
}

void Binder::bind() {
  for (FrameRecord* frame = frames_->first_undecided();
       frame != nullptr && frame->state == FrameState::kMatched;
       frame = frames_->first_undecided()) {
    const LaserChoice choice = choose_laser((*pulses_)[*frame->pulse].lasers, frame->frame.laser);
    if (!choice.doubt.empty()) {
      frames_->drop(*frame, DropReason::kLaserUncertain, choice.doubt);
      continue;
    }
    std::optional<PoseAnswer> answer = rule_->find(*frame->pulse, *pulses_, *poses_);
    if (!answer) return;
    if (!answer->match) {
      frames_->drop(*frame, answer->reason, answer->detail);
      continue;
    }
    answer->match->pass = pass_of(*frame->pulse);
    answer->match->laser = choice.laser;
    frames_->set(*frame, FrameState::kBound);
    decisions_.push_back({frame->number, answer->match});
    settle(*frame->pulse, Fate::kBound);
    count(*answer->match);
  }
}

void Binder::count(const Match& match) {
  ++counts_.frames_bound;
  ++counts_.by_rule[static_cast<int>(match.rule)];
  // The nearest pose used; fmin skips a pose that was not used.
  counts_.worst_time_to_pose =
      std::max(counts_.worst_time_to_pose, std::fmin(match.time_to_before, match.time_to_after));
  counts_.worst_position_error = std::max(counts_.worst_position_error, match.position_error_bound);
}

void Binder::settle(std::size_t pulse, Fate fate) {
  if (fates_[pulse] == Fate::kUnknown) ++settled_;
  fates_[pulse] = std::max(fates_[pulse], fate);
}

bool Binder::latency_doubtful() const {
  if (settled_ == 0) return false;
  const auto without_pulse = [this](std::size_t frame) {
    return std::any_of(dropped_.begin(), dropped_.end(), [frame](const Drop& drop) {
      return drop.frame == frame && drop.reason == DropReason::kNoTrigger;
    });
  };
  return (fates_.front() == Fate::kUnknown && without_pulse(frames_->end() - 1)) ||
         (fates_.back() == Fate::kUnknown && without_pulse(0));
}

Audit Binder::counts() const {
  Audit audit = counts_;
  audit.triggers = std::max<std::uint64_t>(triggers_, pulses_->size());
  audit.triggers_missing = audit.triggers - pulses_->size();
  audit.triggers_refused = pulses_->refused();
  audit.frames = frames_->end();
  audit.poses = poses_->size();
  audit.frames_dropped = dropped_.size();
  audit.latency = matcher_->latency();
  audit.slips = matcher_->slips();
  audit.poses_repeated = poses_->repeated();
  audit.poses_late = poses_->late();
  audit.poses_unusable = poses_->unusable();
  return audit;
}

Audit Binder::audit() const {
  Audit audit = counts();
  audit.latency_doubtful = latency_doubtful();
  audit.dropped = dropped_;
  std::stable_sort(audit.dropped.begin(), audit.dropped.end(),
                   [](const Drop& a, const Drop& b) { return a.frame < b.frame; });
  for (std::size_t i = 0; i < fates_.size(); ++i) {
    if (fates_[i] != Fate::kUnknown) continue;
    ++audit.frames_never_arrived;
    const Pulse& pulse = (*pulses_)[i];
    audit.dropped.push_back({DropReason::kNeverArrived, std::nullopt, 0, pulse.arming, pulse.count,
                             fmt::format("arming {}", pulse.arming)});
  }
  return audit;
}

}  // namespace pose_frame_binder
