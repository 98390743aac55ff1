// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "session_cell.h"
#include "work/work_sequence.h"

namespace scan_cell {
namespace {

using session_test::FakeCell;
using session_test::FakeTrigger;

/// A robot that needs three checks for each motion.
struct FakeFollower : session_test::FakeRobot, Follower {
  using FakeRobot::FakeRobot;
  FollowCheck check_follow(const WorkPlan&) override {
    cell.note("check");
    return {refusal, {1, 2, 3, 4, 5, 6}};
  }
  void set_joint_speed(double share) override { speed = share; }
  void restore_speed() noexcept override { speed = 1; }
  void start_joints(const std::vector<double>& joints) override {
    EXPECT_EQ(speed, 0.1) << "people may stand near";
    EXPECT_EQ(joints.at(5), 6);
    ++cell.pose;
    looks = 0;
    cell.note("joints");
  }
  void start_follow(const WorkPlan& plan) override {
    EXPECT_EQ(speed, 1);
    ++cell.pose;
    looks = 0;
    count = plan.waypoints.size();
    cell.note("follow");
  }
  std::size_t passed() const override {
    return motion_ended_early ? 1 : std::min<std::size_t>(looks, count - 1);
  }
  double speed = 1;
  std::string refusal;
  std::size_t count = 0;
  bool motion_ended_early = false;
};

struct Observer : WorkObserver {
  void on_progress(const std::string& doing, double progress) override {
    EXPECT_GE(progress, last);
    last = progress;
    if (doings.empty() || doings.back() != doing) doings.push_back(doing);
  }
  void on_passed(const WorkWaypoint& waypoint) override {
    EXPECT_EQ(waypoint.tip.translation().x(), passed);
    ++passed;
  }
  double last = 0;
  std::vector<std::string> doings;
  int passed = 0;
};

class Work : public testing::Test {
 protected:
  SequenceEnd run(const WhyToCancel& cancel = [] { return ""; }) {
    WorkPlan plan;
    for (int i = 0; i < 4; ++i) {
      plan.waypoints.emplace_back();
      plan.waypoints.back().tip.translation().x() = i;
    }
    Supervisor::Timing timing;
    timing.stall = 1;
    return WorkSequence(robot_, robot_, trigger_, observer_, timing).run(plan, cancel);
  }

  FakeCell cell_;
  FakeFollower robot_{cell_};
  FakeTrigger trigger_{cell_};
  Observer observer_;
};

TEST_F(Work, GoesToTheFrontAndFollowsThePath) {
  const SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kFinished) << end.message;
  EXPECT_EQ(cell_.log, (std::vector<std::string>{"check", "joints", "follow"}));
  EXPECT_EQ(observer_.doings, (std::vector<std::string>{"check", "approach", "work", "done"}));
  EXPECT_EQ(observer_.passed, 4) << "each waypoint once, in order";
}

TEST_F(Work, NothingMovesWhereThePathCannotBeFollowed) {
  robot_.refusal = "waypoint 3, J5: too fast";
  const SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kRefused);
  EXPECT_EQ(end.message, "waypoint 3, J5: too fast");
  EXPECT_EQ(cell_.count("joints"), 0);
}

TEST_F(Work, NothingMovesWhereTheRobotIsHindered) {
  robot_.hindered = "the emergency stop is pressed";
  EXPECT_EQ(run().outcome, Outcome::kRefused);
  EXPECT_EQ(cell_.count("joints"), 0);
}

TEST_F(Work, AStopOnTheWayEndsItAndWhatWasDoneIsKnown) {
  robot_.ends[2] = {Motion::State::kStopped, 0.5, "emergency stop"};
  robot_.motion_ended_early = true;
  const SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kMotionFailed);
  EXPECT_EQ(end.message, "emergency stop");
  EXPECT_EQ(observer_.passed, 2);
  EXPECT_EQ(cell_.log.back(), "stop robot");
}

TEST_F(Work, AnApproachThatFailsIsFollowedByNothing) {
  robot_.ends[1] = {Motion::State::kFailed, 0, "collision"};
  EXPECT_EQ(run().outcome, Outcome::kMotionFailed);
  EXPECT_EQ(cell_.count("follow"), 0);
  EXPECT_EQ(robot_.speed, 1) << "the speed of others is left as it was";
}

TEST_F(Work, ACancelStopsTheRobotInAnyMotion) {
  for (const char* motion : {"joints", "follow"}) {
    cell_.log.clear();
    observer_ = Observer();
    const SequenceEnd end = run([&] { return cell_.count(motion) > 0 ? "cancelled" : ""; });
    EXPECT_EQ(end.outcome, Outcome::kCancelled);
    EXPECT_EQ(cell_.log.back(), "stop robot") << motion;
  }
}

TEST_F(Work, ADriverThatIsLostEndsIt) {
  cell_.throws_at = "follow";
  EXPECT_EQ(run().outcome, Outcome::kRobotLost);
  EXPECT_EQ(cell_.log.back(), "stop robot");
}

}  // namespace
}  // namespace scan_cell
