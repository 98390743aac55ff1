// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "alignment/agreement.h"
#include "cases/case_list.h"
#include "geometry/kd_tree.h"
#include "tool_path_stretcher/stretcher.h"

using namespace tool_path_stretcher;

namespace {

constexpr double kMillimetre = 1e-3;

/// A square of 100 mm in z = 0, optionally with walls 50 mm down from each side.
Surface square(bool with_walls) {
  constexpr double kStep = 0.002;
  Points points;
  for (double a = -0.05; a <= 0.0501; a += kStep) {
    for (double b = -0.05; b <= 0.0501; b += kStep)
      points.emplace_back(a, b, 0);
    if (!with_walls) continue;
    for (double z = -kStep; z >= -0.0501; z -= kStep) {
      for (const double side : {-0.05, 0.05}) {
        points.emplace_back(a, side, z);
        points.emplace_back(side, a, z);
      }
    }
  }
  return surface_from_cloud(points, {kMillimetre, kMillimetre, kMillimetre}, "square");
}

bool is_beyond(const Surface& surface, const Eigen::Vector3d& point) {
  const Border border(surface, surface.points, surface.spacing);
  const KdTree::Neighbour nearest = surface.tree->nearest(point);
  return border.is_beyond(point, nearest.index, std::sqrt(nearest.squared_distance));
}

/// A case of the benchmark with another scan, rotation and size.
class Partial : public testing::Test {
 protected:
  void scan(const cases::Part& reference, const cases::Part& object, const cases::Scan& first,
            const cases::Scan& second) {
    cases::Scan of_reference = first;
    cases::Scan of_object = second;
    of_reference.seed = 91;
    of_object.seed = 92;
    reference_ = surface_from_cloud(cases::scan(reference, cases::none(), {}, of_reference),
                                    parameters_.leaf, "reference");
    object_ = surface_from_cloud(cases::scan(object, cases::none(), moved_, of_object),
                                 parameters_.leaf, "object");
  }

  StretchResult run(const ToolPath& path) const {
    return stretch(reference_, object_, path, parameters_);
  }

  static cases::Scan of_share(double share, bool far_end = false) {
    cases::Scan scan;
    scan.share = share;
    scan.far_end = far_end;
    return scan;
  }

  Similarity moved_{0.85, cases::random_rotation(17), {0.3, -0.1, 0.2}};
  StretchParameters parameters_;
  Surface reference_;
  Surface object_;
};

}  // namespace

TEST(Border, HasBeyondItWhatLiesPastAnOpenEdgeOnly) {
  const Surface surface = square(false);
  EXPECT_TRUE(is_beyond(surface, {0.06, 0.01, 0}));
  EXPECT_TRUE(is_beyond(surface, {-0.02, -0.09, 0.005}));
  EXPECT_TRUE(is_beyond(surface, {0.08, 0.08, 0}));
  EXPECT_FALSE(is_beyond(surface, {0.01, 0.02, 0.01})) << "above it";
  EXPECT_FALSE(is_beyond(surface, {0.046, 0.01, 0.03})) << "above it, beside its edge";
}

TEST(Border, IsNotWhereASurfaceOnlyBendsSharply) {
  const Surface surface = square(true);
  EXPECT_FALSE(is_beyond(surface, {0.06, 0.01, 0}));
  EXPECT_FALSE(is_beyond(surface, {0, 0.01, 0.02}));
  EXPECT_TRUE(is_beyond(surface, {0.05, 0.01, -0.07})) << "past the lower end of a wall";
}

TEST(Agreement, CountsWhatOnlyOneSurfaceShowsAsNotKnown) {
  const Surface whole = square(false);
  Points half;
  for (const Eigen::Vector3d& point : whole.points) {
    if (point.x() < 0) half.push_back(point);
  }
  const Surface part =
      surface_from_cloud(half, {kMillimetre, kMillimetre, kMillimetre}, "half a square");
  const Agreement agreement = Comparison({part, whole}).under({});
  EXPECT_NEAR(agreement.known, 0.5, 0.03);
  EXPECT_EQ(agreement.agreeing, 1);
  EXPECT_EQ(agreement.contradicted(0.1 * kMillimetre), 0);
}

TEST(Agreement, IsContradictedWhereOneSurfaceLiesOffTheOther) {
  const Surface flat = square(false);
  Points bumpy = flat.points;
  double raised = 0;
  for (Eigen::Vector3d& point : bumpy) {
    if (point.head<2>().norm() > 0.02) continue;
    point.z() += 3 * kMillimetre;
    raised += 1;
  }
  const Surface other =
      surface_from_cloud(bumpy, {kMillimetre, kMillimetre, kMillimetre}, "bumpy square");
  const double contradicted = Comparison({flat, other}).under({}).contradicted(0.1 * kMillimetre);
  EXPECT_NEAR(contradicted, raised / static_cast<double>(bumpy.size()), 0.03);
}

TEST_F(Partial, ReferenceOfSixtyPercentIsEnough) {
  const cases::Part part = cases::with_path_within(cases::ribbed_plate(), 0.1, 0.5);
  scan(part, part, of_share(0.6), of_share(1));
  const StretchResult result = run(part.path);
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  const auto error =
      cases::error_of(result.path, cases::truth(part.path, cases::none(), moved_), {});
  EXPECT_LT(error.worst, 0.3 * kMillimetre);
  EXPECT_NE(result.verdict.message.find("only a part"), std::string::npos)
      << result.verdict.message;
}

TEST_F(Partial, ReferenceOfAnotherPartIsRefused) {
  const cases::Part part = cases::with_path_within(cases::curved_panel(), 0.1, 0.5);
  scan(part, cases::other_panel(), of_share(0.6), of_share(1));
  EXPECT_EQ(to_string(run(part.path).verdict.reason), "wrong_part");
}

TEST_F(Partial, ScansOfOtherEndsOfWhatIsNearlyItsOwnImageAreAmbiguous) {
  // Half a turn off, the whole scan is explained except for the rosette, which only one of them
  // shows.
  const cases::Part part = cases::with_path_within(cases::photo_frame(0.003), 0.4, 0.7);
  cases::Scan begin = of_share(0.75);
  cases::Scan end = of_share(0.65, true);
  begin.from_above = end.from_above = true;
  scan(part, part, begin, end);
  const StretchResult result = run(part.path);
  ASSERT_EQ(to_string(result.verdict.reason), "ambiguous") << result.verdict.message;
  ASSERT_EQ(result.verdict.candidates.size(), 2U);
  const Similarity& one = result.verdict.candidates[0].similarity;
  const Similarity& other = result.verdict.candidates[1].similarity;
  const double nearest = std::min(distance(one, moved_, reference_.points),
                                  distance(other, moved_, reference_.points));
  EXPECT_LT(nearest, 3 * kMillimetre) << "the true pose is one of the two";
}
