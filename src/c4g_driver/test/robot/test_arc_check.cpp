// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// What prevents an arc whose start, via and end are valid. The reference is motions of one axis,
/// which move the flange on a circle and turn it along.
#include <cmath>

#include "robot/motion_check_test.h"

using c4g_driver::expect_says;
using c4g_driver::Joints;
using c4g_driver::MotionCheckTest;
using Eigen::Isometry3d;

namespace {

class ArcCheckTest : public MotionCheckTest {
 protected:
  /// Where the arc was refused [%].
  static int place_in(const std::string& said) {
    const std::size_t end = said.find(" % of the way");
    return end == std::string::npos ? -1 : std::stoi(said.substr(said.rfind(' ', end - 1)));
  }
};

}  // namespace

TEST_F(ArcCheckTest, LetsPassAnArcRoundAPart) {
  Isometry3d via = looking_down(0.9, 0.1, 0.6), end = looking_down(0.8, 0.2, 0.55);
  via.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()));
  end.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
  EXPECT_EQ(refusal_of_arc(via, end), "");
  settings_.in_joints = settings_.euler = true;
  EXPECT_EQ(refusal_of_arc(via, end), "") << "an arc is one whatever is set for lines";
}

TEST_F(ArcCheckTest, NamesTheAxesOfASingularPostureBetweenItsThreePoses) {
  stand(degrees(0, 0, -90, 0, 60, 0));
  EXPECT_EQ(refusal_of_arc(at_j5(40), at_j5(10)), "");
  const std::string said = refusal_of_arc(at_j5(30), at_j5(-40));
  expect_says(said, "arc: passes a singular posture of J4 and J6 at ");
  EXPECT_NEAR(place_in(said), 60, 3);  // J5 is 0 after 60 of 100 degrees
}

TEST_F(ArcCheckTest, NamesTheJointThatLeavesItsRangeBetweenItsThreePoses) {
  stand(degrees(150, 0, -90, 0, 70, 0));
  EXPECT_EQ(refusal_of_arc(at_j1(160), at_j1(169)), "");
  const std::string said = refusal_of_arc(at_j1(160), at_j1(-160));  // over 170, the range's end
  expect_says(said, "arc, J1: 2.9");
  expect_says(said, "its range is -2.96706 .. 2.96706 rad");
  EXPECT_NEAR(place_in(said), 40, 3);  // 20 of 50 degrees
}

TEST_F(ArcCheckTest, GoesTheLongWayRoundThatViaNames) {
  stand(degrees(-100, 0, -90, 0, 70, 0));
  EXPECT_EQ(refusal_of_arc(at_j1(0), at_j1(100)), "") << "200 degrees in front";
  expect_says(refusal_of_arc(at_j1(-150), at_j1(100)), "arc, J1: -2.9");  // 160 behind
}

TEST_F(ArcCheckTest, NamesWhereItLeavesTheReachBetweenItsThreePoses) {
  limits_.workspace_max.x() = 2;
  const auto on_circle = [](double angle) {
    const double radian = angle * M_PI / 180;
    return looking_down(0.9 + 0.5 * std::cos(radian), 0.5 * std::sin(radian), 0.6);
  };
  stand(*c4g_driver::step_to(
      smart5_six(), on_circle(-60),
      c4g_driver::postures_for(smart5_six(), on_circle(-60), degrees(0, 30, -90, 0, 60, 0))
          .joints.front()));
  EXPECT_EQ(refusal_of_arc(on_circle(-50), on_circle(-40)), "");
  const std::string said = refusal_of_arc(on_circle(-40), on_circle(60));
  EXPECT_EQ(said.find("arc"), 0u) << said;
  // stretched out the wrist's centre is 1.376 m from the base: 0.9 + 0.5 cos 29 degrees beside it
  EXPECT_GT(place_in(said), 17) << said;
  EXPECT_LT(place_in(said), 40) << said;
}

TEST_F(ArcCheckTest, NamesWhereItLeavesTheWorkspaceBetweenItsThreePoses) {
  // half a circle of 0.1 m out to x = 0.9, with via in its first part
  const Isometry3d via = looking_down(0.83, 0.1 - std::sqrt(0.01 - 0.0009), 0.6);
  const Isometry3d end = looking_down(0.8, 0.2, 0.6);
  EXPECT_EQ(refusal_of_arc(via, end), "");
  limits_.workspace_max.x() = 0.85;
  expect_says(refusal_of_arc(via, end), "way of the flange, x: 0.85");
}

TEST_F(ArcCheckTest, NamesThePoseThatIsItselfOutOfReach) {
  limits_.workspace_max = {3, 3, 3};
  expect_says(refusal_of_arc(looking_down(1.5, 0.1, 0.6), looking_down(0.8, 0.2, 0.6)),
              "via: out of reach by 0.");
  expect_says(refusal_of_arc(looking_down(0.9, 0.1, 0.6), looking_down(1.5, 0.2, 0.6)),
              "target: out of reach by 0.");
}

TEST_F(ArcCheckTest, NamesTheJointThatItAsksTooMuchSpeedOf) {
  const Joints folded = degrees(-60, -30, -140, 0, 80, 0);
  stand(folded);
  const auto turned = [&](double angle) {
    return flange_by_denavit_hartenberg(folded + degrees(angle, 0, 0, 0, 0, 0));
  };
  const double radius = from_.flange.translation().head<2>().norm();
  settings_.linear_speed = 1.5;
  settings_.rotational_speed = 10;
  ASSERT_GT(settings_.linear_speed / radius, 1.1 * smart5_six().speed()[0]);
  expect_says(refusal_of_arc(turned(40), turned(100)), "speed of J1: ");
  settings_.override = 1;
  EXPECT_NEAR(check().along_arc(turned(40), turned(100)).max_override,
              100 * smart5_six().speed()[0] * radius / settings_.linear_speed, 0.01);
  settings_.override = 100;
  settings_.rotational_speed = 1;  // now this decides
  EXPECT_EQ(refusal_of_arc(turned(40), turned(100)), "");
}

TEST_F(ArcCheckTest, RefusesAnArcWhileAFasterSpeedIsSetThanTheCellAllows) {
  settings_.linear_speed = 0.3;
  const Isometry3d via = looking_down(0.9, 0.1, 0.6), end = looking_down(0.8, 0.2, 0.6);
  EXPECT_EQ(refusal_of_arc(via, end), "");
  limits_.operation = c4g_driver::Operation::kManual;
  expect_says(refusal_of_arc(via, end), "linear speed set on the controller: 0.3 m/s");
}
