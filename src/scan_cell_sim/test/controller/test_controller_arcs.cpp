// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Arcs of the emulated arm, compared with circles in closed form and with motions of one axis,
/// which move the flange on a circle and turn it along.
#include <memory>
#include <string>

#include "controller/arm_truth.h"
#include "controller/motion/motion_control.h"

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using scan_cell_common::from_seconds;
using scan_cell_common::Nanoseconds;
using scan_cell_sim::ControllerErrorCode;
using scan_cell_sim::Joints;
using scan_cell_sim::MotionControl;
using scan_cell_sim::MotionStatus;
using scan_cell_sim::plan_arc;

namespace {

constexpr double kPlace = 0.05e-3;        // [m] what the arc may be off
constexpr double kTurn = 0.01 * kDegree;  // [rad]

Joints with_j1(double degrees_of_j1) {
  return degrees(degrees_of_j1, 0, -90, 0, 70, 0);
}

/// Posture turned by J5 alone, 95 mm round the wrist's centre.
Joints with_j5(double degrees_of_j5) {
  return degrees(0, 0, -90, 0, degrees_of_j5, 0);
}

ControllerErrorCode refused_arc(const Joints& from, const Joints& via, const Joints& to) {
  return refusal(
      [&] { plan_arc(from, product_of_exponentials(via), product_of_exponentials(to), {}); });
}

/// A tilted circle in front of the robot, with the flange turned more in its second part.
struct Circle {
  Vector3d centre{0.80, 0.02, 0.65};
  double radius = 0.12;
  AngleAxisd tilt{0.5, Vector3d(1, 1, 0).normalized()};
  AngleAxisd first{40 * kDegree, Vector3d::UnitZ()};                // of the flange, to via
  AngleAxisd second{35 * kDegree, Vector3d(1, 0, 2).normalized()};  // from there on

  Vector3d place(double angle) const {
    return centre + tilt * (radius * Vector3d(std::cos(angle), std::sin(angle), 0));
  }

  /// @param angle, via_angle, end_angle [rad] on the circle
  Isometry3d at(double angle, double via_angle, double end_angle) const {
    Isometry3d pose = looking_down(0, 0, 0);
    pose.translation() = place(angle);
    const bool late = angle > via_angle;
    const double part = late ? (angle - via_angle) / (end_angle - via_angle) : angle / via_angle;
    const auto share = [](const AngleAxisd& turn, double of_it) {
      return AngleAxisd(of_it * turn.angle(), turn.axis());
    };
    pose.rotate(share(first, late ? 1 : part));
    if (late) pose.rotate(share(second, part));
    return pose;
  }
};

class Arc : public testing::Test {
 protected:
  void begin(double via_angle, double end_angle) {
    via_ = via_angle;
    end_ = end_angle;
    control_->move_along_arc(7, truth(via_), truth(end_), 100, kStart);
  }

  Isometry3d truth(double angle) const { return circle_.at(angle, via_, end_); }

  scan_cell_sim::MotionState at(double seconds) const {
    return control_->state(kStart + from_seconds(seconds));
  }

  /// Checks how far the arm's pose is from that of the definition, at the arm's progress.
  void expect_on_the_arc(const scan_cell_sim::MotionState& state) {
    const Isometry3d arm = product_of_exponentials(state.joints);
    const Isometry3d expected = truth(state.progress * end_);
    const double off = (arm.translation() - expected.translation()).norm();
    const double turned = AngleAxisd(arm.linear().transpose() * expected.linear()).angle();
    farthest_ = std::max(farthest_, off);
    most_turned_ = std::max(most_turned_, turned);
    EXPECT_LT(off, kPlace);
    EXPECT_LT(turned, kTurn);
    expect_same(state.flange, arm, 1e-8);
  }

  double duration() const {
    double seconds = 0;
    while (at(seconds).status == MotionStatus::kMoving)
      seconds += 0.01;
    return seconds;
  }

  Circle circle_;
  double via_ = 100 * kDegree;
  double end_ = 160 * kDegree;
  double farthest_ = 0;     // [m]
  double most_turned_ = 0;  // [rad]
  Joints start_ = scan_cell_sim::reach(circle_.at(0, 1, 2), degrees(0, 8, -124, 0, 48, 0));
  std::unique_ptr<MotionControl> control_ = std::make_unique<MotionControl>(start_);
};

}  // namespace

TEST_F(Arc, StaysOnItsCircleAndTurnsAsItsDefinitionSays) {
  for (const double end : {160, 359}) {
    control_ = std::make_unique<MotionControl>(start_);
    begin(100 * kDegree, end * kDegree);
    double progress = 0;
    for (double seconds = 0; progress < 1; seconds += 0.004) {
      const auto state = at(seconds);
      expect_on_the_arc(state);
      ASSERT_GE(state.progress, progress);
      progress = state.progress;
    }
  }
  RecordProperty("farthest_nm", std::to_string(1e9 * farthest_));
  RecordProperty("most_turned_udeg", std::to_string(1e6 * most_turned_ / kDegree));
}

TEST_F(Arc, HasTheOrientationOfViaAtVia) {
  const Isometry3d via = truth(via_);
  const auto plan = plan_arc(start_, via, truth(end_), {});
  expect_same(product_of_exponentials(plan.path->joints(via_ / end_)), via, 1e-8);
  expect_same(product_of_exponentials(plan.path->joints(1)), truth(end_), 1e-8);
}

TEST_F(Arc, RunsAtTheConstantSpeedThatWasAskedFor) {
  scan_cell_sim::MotionSettings settings;
  settings.line.speed = 0.1;
  settings.override = 0.5;
  control_->set(settings, kStart);
  begin(100 * kDegree, 250 * kDegree);
  const double length = circle_.radius * end_;
  const double wanted = 0.05;
  const double start_up = wanted / settings.line.acceleration;
  EXPECT_NEAR(duration(), length / wanted + start_up, 0.02);
  double slowest = 1, fastest = 0;
  for (double seconds = start_up; seconds < length / wanted - 0.01; seconds += 0.01) {
    const Vector3d before = product_of_exponentials(at(seconds).joints).translation();
    const Vector3d after = product_of_exponentials(at(seconds + 0.01).joints).translation();
    const double angle = 2 * std::asin((after - before).norm() / (2 * circle_.radius));
    slowest = std::min(slowest, angle * circle_.radius / 0.01);
    fastest = std::max(fastest, angle * circle_.radius / 0.01);
  }
  EXPECT_GT(slowest, 0.98 * wanted);
  EXPECT_LT(fastest, 1.02 * wanted);
  RecordProperty("slowest_um_s", std::to_string(1e6 * slowest));
  RecordProperty("fastest_um_s", std::to_string(1e6 * fastest));
}

TEST_F(Arc, IsRunSoSlowlyThatItTurnsNoFasterThanItMay) {
  scan_cell_sim::MotionSettings settings;
  settings.line.speed = 1.5;
  settings.line.rotational_speed = 20 * kDegree;
  control_->set(settings, kStart);
  begin(100 * kDegree, 120 * kDegree);  // its second part turns by 35 degrees over 20
  double fastest = 0;
  const double end = duration();
  for (double seconds = 0; seconds < end; seconds += 0.01) {
    const Eigen::Matrix3d turn =
        at(seconds).flange.linear().transpose() * at(seconds + 0.01).flange.linear();
    fastest = std::max(fastest, AngleAxisd(turn).angle() / 0.01);
  }
  EXPECT_NEAR(fastest, 20 * kDegree, 0.01 * kDegree);
}

TEST_F(Arc, GoesTheLongWayRoundWhereViaSaysSo) {
  begin(200 * kDegree, 300 * kDegree);
  const double speed = 0.25, acceleration = 1.0;  // the defaults
  EXPECT_NEAR(duration(), circle_.radius * end_ / speed + speed / acceleration, 0.02);
  EXPECT_LT((at(duration() / 2).flange.translation() - circle_.place(end_ / 2)).norm(), 1e-3);
}

TEST_F(Arc, StopsOnTheArcAndNeverGoesOn) {
  begin(100 * kDegree, 300 * kDegree);
  const double stop = 1.2;
  const double speed = 0.25, acceleration = 1.0;  // the defaults
  control_->stop(std::nullopt, kStart + from_seconds(stop));
  for (double seconds = stop; seconds < stop + 0.5; seconds += 0.004)
    expect_on_the_arc(at(seconds));
  const auto stopped = at(stop + 0.3);
  EXPECT_EQ(stopped.status, MotionStatus::kStopped);
  // v^2 / 2a to start, what lies between, and v^2 / 2a to brake
  const double way = speed * speed / acceleration + speed * (stop - speed / acceleration);
  EXPECT_NEAR(stopped.progress, way / (circle_.radius * end_), 1e-6);
  control_->set(control_->settings(), kStart + from_seconds(stop + 0.4));
  EXPECT_EQ(at(1000).progress, stopped.progress);
  expect_same(at(1000).flange, stopped.flange, 1e-12);
}

TEST_F(Arc, IsNeverFasterThan250MillimetresASecondInModeProgramming) {
  scan_cell_sim::MotionSettings settings;
  settings.line.speed = 1;
  control_->set(settings, kStart);
  control_->select(scan_cell_sim::ControllerMode::kProgramming, kStart);
  control_->switch_drives(true, scan_cell_sim::Readiness::Source::kPanel, kStart);
  begin(100 * kDegree, 300 * kDegree);
  const double way = (at(1.01).progress - at(1).progress) * circle_.radius * end_;
  EXPECT_LT(way / 0.01, 0.2501);
  EXPECT_GT(way / 0.01, 0.249);
}

TEST(ArcOfOneAxis, MovesThatAxisAloneAndEvenly) {
  struct Case {
    Joints (*posture)(double);
    double from, via, to;
  };
  for (const Case& turn : {Case{with_j1, -40, 0, 60}, Case{with_j1, -130, 10, 120},
                           Case{with_j1, 100, 30, -60}, Case{with_j5, 80, 40, 10}}) {
    const auto plan =
        plan_arc(turn.posture(turn.from), product_of_exponentials(turn.posture(turn.via)),
                 product_of_exponentials(turn.posture(turn.to)), {});
    for (double way = 0; way <= 1; way += 1.0 / 64) {
      const Joints expected = turn.posture(turn.from + way * (turn.to - turn.from));
      EXPECT_LT((plan.path->joints(way) - expected).norm(), 1e-6) << turn.from << " at " << way;
    }
  }
}

TEST(ArcOfOneAxis, IsRefusedWhereItLeavesTheRange) {
  EXPECT_EQ(refused_arc(with_j1(130), with_j1(150), with_j1(-165)),
            ControllerErrorCode::kJointLimit);
}

TEST(ArcOfOneAxis, IsRefusedWhereItPassesASingularPosture) {
  // start, via and end are far from the straight wrist, which lies between via and end
  EXPECT_EQ(refused_arc(with_j5(60), with_j5(30), with_j5(-45)), ControllerErrorCode::kSingular);
  EXPECT_EQ(refused_arc(with_j5(60), with_j5(-30), with_j5(-45)), ControllerErrorCode::kSingular);
}

TEST(ArcThatLeavesTheReach, IsRefusedThoughItsThreePosesAreWithin) {
  // with the arm stretched out, the wrist's centre is 1.376 m from the base at this height
  const auto on_circle = [](double angle) {
    return looking_down(0.9 + 0.5 * std::cos(angle * kDegree), 0.5 * std::sin(angle * kDegree),
                        0.6);
  };
  const Joints from = scan_cell_sim::reach(on_circle(-60), degrees(0, 0, -90, 0, 90, 0));
  EXPECT_EQ(refusal([&] { plan_arc(from, on_circle(-40), on_circle(60), {}); }),
            ControllerErrorCode::kOutOfReach);
  EXPECT_NO_THROW(plan_arc(from, on_circle(-50), on_circle(-40), {}));
  EXPECT_EQ(refusal([&] { plan_arc(from, on_circle(-40), looking_down(99, 99, 0.6), {}); }),
            ControllerErrorCode::kOutOfReach);
}

TEST(ArcOfNoCircle, IsRefusedByName) {
  const Isometry3d start = looking_down(0.8, 0, 0.6);
  const Joints from = scan_cell_sim::reach(start, Joints::Zero());
  const auto said = [&](const Isometry3d& via, const Isometry3d& to) -> std::string {
    try {
      plan_arc(from, via, to, {});
    } catch (const scan_cell_sim::ControllerRefusal& refused) {
      EXPECT_EQ(refused.code(), ControllerErrorCode::kNoArc);
      return refused.what();
    }
    return "";
  };
  const Isometry3d via = looking_down(0.85, 0.05, 0.6);
  const Isometry3d to = looking_down(0.8, 0.1, 0.6);
  EXPECT_EQ(said(via, to), "");
  EXPECT_EQ(said(looking_down(0.8, 0.0009, 0.6), to), "via is nearer than 1 mm to the start");
  EXPECT_EQ(said(via, via), "the pose is nearer than 1 mm to via");
  EXPECT_EQ(said(via, start), "the pose is nearer than 1 mm to the start");
  for (const double y : {0.05, -0.05, 0.15})
    EXPECT_EQ(said(looking_down(0.80009, y, 0.6), to), "start, via and pose lie on a line") << y;
  EXPECT_EQ(said(looking_down(0.80011, 0.05, 0.6), to), "");
  Isometry3d turned = via;
  turned.rotate(AngleAxisd(M_PI, Vector3d::UnitZ()));
  EXPECT_EQ(said(turned, to), "the turn to via is half a turn: its direction is ambiguous");
  EXPECT_EQ(said(via, to * AngleAxisd(M_PI, Vector3d::UnitZ())),
            "the turn from via is half a turn: its direction is ambiguous");
}
