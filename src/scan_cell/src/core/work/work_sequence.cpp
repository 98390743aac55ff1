// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "work/work_sequence.h"

#include <algorithm>
#include <exception>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {
namespace {

constexpr double kApproach = 0.1;  // share of the whole time; a guess for the progress bar

}  // namespace

WorkSequence::WorkSequence(Robot& robot, Follower& follower, Trigger& trigger,
                           WorkObserver& observer, const Supervisor::Timing& timing)
    : robot_(robot),
      follower_(follower),
      observer_(observer),
      supervisor_(robot, trigger, {}, timing) {}

SequenceEnd WorkSequence::run(const WorkPlan& plan, const WhyToCancel& why_to_cancel) {
  supervisor_.begin(why_to_cancel);
  told_ = 0;
  SequenceEnd end;
  try {
    work(plan);
  } catch (const EndEarly& early) {
    end = {early.outcome, early.message};
  } catch (const std::exception& error) {  // of any kind: the robot must stand
    end = {Outcome::kMotionFailed, error.what()};
  }
  supervisor_.stop_robot();
  follower_.restore_speed();
  return end;
}

void WorkSequence::work(const WorkPlan& plan) {
  observer_.on_progress("check", 0);
  supervisor_.wait_until_well();
  refuse_what_hinders();
  const FollowCheck check =
      on(Outcome::kRefused, Outcome::kRobotLost, [&] { return follower_.check_follow(plan); });
  if (!check.refusal.empty()) throw EndEarly{Outcome::kRefused, check.refusal};
  on_robot([&] { follower_.set_joint_speed(plan.joint_speed); });
  supervisor_.start_other([&] { follower_.start_joints(check.start); });
  supervisor_.wait_for_motion(
      [&](double progress) { observer_.on_progress("approach", kApproach * progress); });
  follower_.restore_speed();
  supervisor_.start_other([&] { follower_.start_follow(plan); });
  try {
    supervisor_.wait_for_motion([&](double progress) {
      tell_passed(plan);
      observer_.on_progress("work", kApproach + (1 - kApproach) * progress);
    });
  } catch (...) {
    tell_passed(plan);  // reports what was done, however it ended
    throw;
  }
  tell_passed(plan);
  observer_.on_progress("done", 1);
}

void WorkSequence::refuse_what_hinders() {
  const std::string hindrance = robot_.hindrance();
  if (!hindrance.empty()) throw EndEarly{Outcome::kRefused, "robot: " + hindrance};
}

void WorkSequence::tell_passed(const WorkPlan& plan) {
  const std::size_t passed = std::min(follower_.passed() + 1, plan.waypoints.size());
  for (; told_ < passed; ++told_)
    observer_.on_passed(plan.waypoints[told_]);
}

}  // namespace scan_cell
