// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stretch_case.h"
#include "thesis/registrations.h"

using namespace tool_path_stretcher;

namespace {

const auto kNoProgress = [](double) {};

/// The part rotated slightly and moved by millimetres: the thesis' methods start from where the
/// clouds lie.
Case nearby(Method method, double scale) {
  const double turn = method == Method::kThesisAffine ? 0.5 : 3;  // [deg]
  Case each;
  each.parameters.method = method;
  each.moved = synthetic::similarity(scale, about_vertical(turn), {0.004, -0.003, 0.002});
  return each;
}

Points moved(const Points& points, const Similarity& by) {
  Points result;
  for (const Eigen::Vector3d& point : points)
    result.push_back(by * point);
  return result;
}

}  // namespace

TEST(ThesisRegistrations, LeadFromTheReferenceToTheObject) {
  const Points reference = Case().reference().points;
  const Similarity truth = synthetic::similarity(1.2, about_vertical(0.5), {0.5, -0.2, 0.1});
  const Points object = moved(reference, truth);
  EXPECT_NEAR(ratio_of_principal_axes(reference, object), 1.2, 1e-6);
  const Consensus consensus =
      register_by_consensus(reference, object, {1.2, 0.1, 5}, 0.002, kNoProgress);
  EXPECT_DOUBLE_EQ(consensus.similarity.scale, 1.2);
  EXPECT_FALSE(consensus.at_bound);
  EXPECT_LT(distance(consensus.similarity, truth, reference), 0.001);
  const Similarity near{1.2, truth.rotation, {0.002, 0.001, 0}};
  EXPECT_LT(distance(register_by_icp(reference, moved(reference, near), 1.2), near, reference),
            1e-4);
}

TEST(ThesisRegistrations, GiveTheSameForTheSameInput) {
  const Points reference = Case().reference().points;
  const Points object = Case().object().points;
  const auto run = [&] {
    return register_by_consensus(reference, object, {1.08, 0.05, 2}, 0.002, kNoProgress);
  };
  EXPECT_EQ(run().similarity.matrix(), run().similarity.matrix());
}

TEST(ThesisAffine, AdaptsThePathOfAPartOfAnotherSize) {
  const Case each = nearby(Method::kThesisAffine, 1.05);
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_EQ(to_string(result.method), "thesis_affine");
  EXPECT_LE(each.error(result).rms, 0.002);  // RANSAC with points 2 mm apart
}

TEST(ThesisGeneral, PutsEachWaypointOnAScannedPoint) {
  const Case each = nearby(Method::kThesisGeneral, 1.0);
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  const Points object = each.object().points;
  for (const Segment& segment : result.path.segments) {
    for (const Waypoint& waypoint : segment.waypoints) {
      const auto is_there = [&](const Eigen::Vector3d& point) {
        return point == waypoint.pose.translation();
      };
      EXPECT_TRUE(std::any_of(object.begin(), object.end(), is_there));
    }
  }
  EXPECT_LE(each.error(result).rms, 0.002);
}

TEST(ThesisGeneral, ExpectsWhatTheNearestPointLeavesOpen) {
  const Case each = nearby(Method::kThesisGeneral, 1.0);
  const double spacing = each.object().spacing;
  for (const WaypointQuality& quality : each.run().quality)
    EXPECT_GE(quality.expected_error_tangential, spacing / std::sqrt(6.0));
}

TEST(ThesisMethods, AreRefusedWhereTheirRegistrationEndsInAWrongPose) {
  for (const Method method : {Method::kThesisAffine, Method::kThesisGeneral}) {
    SCOPED_TRACE(to_string(method));
    Case each = nearby(method, 1.0);
    each.moved.rotation = about_vertical(180);
    EXPECT_FALSE(each.run().verdict.accepted());
  }
}

TEST(ThesisMethods, StartFromTheInitialPose) {
  Case each = nearby(Method::kThesisGeneral, 1.0);
  each.moved.rotation = about_vertical(120);
  each.moved.translation = {0.3, 0.2, 0.1};
  PosePrior prior;
  prior.pose = Eigen::Translation3d(0.301, 0.202, 0.1) * Eigen::Quaterniond(about_vertical(118));
  each.parameters.prior.pose = prior;
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_LE(each.error(result).rms, 0.002);
}
