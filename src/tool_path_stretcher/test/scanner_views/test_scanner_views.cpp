// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "geometry/kd_tree.h"
#include "scanner_views/case_list.h"
#include "scanner_views/figures/outcome.h"

using namespace scanner_views;
using Eigen::Vector3d;

TEST(ViewCases, TheSameSeedGivesTheSameBytesAndAnotherOneOthers) {
  const ViewCase each = all_cases(1, "").front();
  const View one = view_of(each), same = view_of(all_cases(1, "").front());
  EXPECT_EQ(one.object.places, same.object.places);
  EXPECT_NE(one.object.places.size(), view_of(all_cases(2, "").front()).object.places.size());
}

TEST(ViewCases, TheTruthLiesOnTheScannedPart) {
  constexpr std::size_t kEvery = 5;  // cases, to save time
  constexpr double kNear = 0.002;    // [m] lines are 1 to 1.6 mm apart
  std::size_t number = 0;
  for (const ViewCase& each : all_cases(1, "")) {
    if (each.family != "bent" || number++ % kEvery != 0) continue;
    const View view = view_of(each);
    const tool_path_stretcher::KdTree tree(view.object.places);
    std::size_t far = 0, count = 0;
    for (const auto& segment : view.truth.segments) {
      for (const auto& waypoint : segment.waypoints) {
        far += tree.nearest(waypoint.pose.translation()).squared_distance > kNear * kNear;
        ++count;
      }
    }
    EXPECT_GE(count, 50U) << each.name();
    EXPECT_LE(far, count / 10) << each.name();
  }
}

/// A case of seed 1.
ViewCase case_of(const std::string& family, const std::string& name) {
  for (const ViewCase& each : all_cases(1, "")) {
    if (each.family == family && each.name() == name) return each;
  }
  throw std::out_of_range("no case " + family + ": " + name);
}

struct Named {
  const char* family;
  const char* name;
  Worth worth;
};

class StretchedViews : public testing::TestWithParam<Named> {};

TEST_P(StretchedViews, AreAcceptedInTheRightPlaceOrRefused) {
  const ViewCase each = case_of(GetParam().family, GetParam().name);
  const View view = view_of(each);
  ASSERT_EQ(view.not_cleaned, "");
  const Outcome outcome = outcome_of(run_ours(view), each, view);
  EXPECT_EQ(outcome.worth, GetParam().worth)
      << to_string(outcome.worth) << " " << outcome.answer.verdict << outcome.answer.message;
  EXPECT_LT(outcome.errors.normal, 0.0001) << "[m] the benchmark's goal";
  EXPECT_LT(outcome.errors.tangential, 0.0005);
  EXPECT_LT(outcome.errors.angle, M_PI / 180);
}

// Cases answered correctly and quickly; the benchmark has all.
INSTANTIATE_TEST_SUITE_P(
    , StretchedViews,
    testing::Values(Named{"moved", "cast body, moved", Worth::kRight},
                    Named{"bent", "frame, bent", Worth::kRight},
                    Named{"scaled, scan as reference", "gear plate, scaled, scan as reference",
                          Worth::kRight},
                    Named{"in a scene, cleaned", "frame, in a scene, cleaned", Worth::kRight},
                    Named{"to refuse", "cast body, mirrored", Worth::kRefusedRightly}));

TEST(Outcomes, AWaypointTurnedOrMovedTooFarIsWrong) {
  ViewCase each;
  View view;
  view.truth.segments.push_back({"line", std::vector<tool_path_stretcher::Waypoint>(10)});
  Answer answer;
  answer.accepted = true;
  answer.path = view.truth;
  EXPECT_EQ(outcome_of(answer, each, view).worth, Worth::kRight);

  auto& pose = answer.path.segments[0].waypoints[3].pose;
  pose.translation() = Vector3d(0.003, 0, 0.0005);
  const Outcome moved = outcome_of(answer, each, view);
  EXPECT_EQ(moved.worth, Worth::kRight);
  EXPECT_NEAR(moved.errors.normal, 0.0005 / std::sqrt(10), 1e-12);
  EXPECT_NEAR(moved.errors.tangential, 0.003 / std::sqrt(10), 1e-12);

  pose.translation() = Vector3d(0, 0, 0.0011);
  EXPECT_EQ(outcome_of(answer, each, view).worth, Worth::kWrong);
  pose.translation() = Vector3d(0.0051, 0, 0);
  EXPECT_EQ(outcome_of(answer, each, view).worth, Worth::kWrong);
  pose.translation().setZero();
  pose.linear() = Eigen::AngleAxisd(5.1 * M_PI / 180, Vector3d::UnitX()).toRotationMatrix();
  EXPECT_EQ(outcome_of(answer, each, view).worth, Worth::kWrong);

  each.expected = Reason::kAmbiguous;
  EXPECT_EQ(outcome_of(answer, each, view).worth, Worth::kWrong);
  answer.accepted = false;
  EXPECT_EQ(outcome_of(answer, each, view).worth, Worth::kRefusedRightly);
  each.expected = Reason::kAccepted;
  EXPECT_EQ(outcome_of(answer, each, view).worth, Worth::kRefusedNeedlessly);
}
