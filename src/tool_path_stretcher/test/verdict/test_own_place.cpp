// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "synthetic_parts.h"
#include "tool_path_stretcher/stretcher.h"

using namespace tool_path_stretcher;

namespace {

/// A panel of 300 x 200 mm and its surroundings.
struct Scene {
  synthetic::Part part = synthetic::curved_panel();
  ToolPath path = synthetic::path_on(part, 100);
  Similarity moved = synthetic::similarity(
      1, Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix(), {0.2, -0.1, 0.05});
  Points scan;

  Scene() { add(part, moved, 1); }

  void add(const synthetic::Part& other, const Similarity& similarity, unsigned seed) {
    synthetic::Scan how;
    how.seed = seed;
    const Points more = synthetic::scan(other, similarity, synthetic::no_deformation(), how);
    scan.insert(scan.end(), more.begin(), more.end());
  }

  /// Adds a flat rectangle [m] in the part's frame, level except for its rotation, about as dense
  /// as the scan.
  void add_plate(const Eigen::Vector3d& middle, double width, double depth,
                 const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity()) {
    constexpr double kDensity = 20000 / 0.06;  // [1/m^2]
    std::mt19937 random(7);
    std::uniform_real_distribution<double> along(-0.5, 0.5);
    std::normal_distribution<double> noise(0, 1e-4);
    const int count = static_cast<int>(kDensity * width * depth);
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d at(width * along(random), depth * along(random), noise(random));
      scan.push_back(moved * (middle + turn * at));
    }
  }

  StretchResult run(const synthetic::Part& reference, const ToolPath& on_it) const {
    StretchParameters parameters;
    synthetic::Scan how;
    how.seed = 11;
    const Points points = synthetic::scan(reference, {}, synthetic::no_deformation(), how);
    return stretch(surface_from_cloud(points, parameters.leaf, "reference"),
                   surface_from_cloud(scan, parameters.leaf, "object"), on_it, parameters);
  }

  StretchResult run() const { return run(part, path); }

  ToolPath truth() const { return synthetic::truth(path, moved, synthetic::no_deformation()); }
};

}  // namespace

TEST(OwnPlace, IsExplainedWhereClampsMakeUpAThirdOfTheScan) {
  Scene scene;
  for (const double side : {-1.0, 1.0}) {  // upright, and too close for a gap to separate them
    constexpr double kBeside = 0.143, kHigh = 0.15;  // [m]
    const double foot = scene.part.height(side * kBeside, 0);
    scene.add_plate({side * kBeside, 0, foot + kHigh / 2}, kHigh, 0.15,
                    Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY())));
  }
  const StretchResult result = scene.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_LE(synthetic::error_of(result.path, scene.truth()).max, 0.0005);
  EXPECT_NE(result.verdict.message.find("belong to other things"), std::string::npos)
      << result.verdict.message;
  EXPECT_GT(result.inlier_ratio, 0.98);
}

TEST(OwnPlace, IsFoundBesideALargerThing) {
  Scene scene;
  scene.add_plate({0.05, 0.4, 0.01}, 0.36, 0.26);
  const StretchResult result = scene.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_LE(synthetic::error_of(result.path, scene.truth()).max, 0.0005);
}

TEST(OwnPlace, OfTwoThingsAlikeIsAmbiguous) {
  Scene scene;
  Similarity beside = scene.moved;
  beside.translation += Eigen::Vector3d(0.1, 0.4, 0);
  scene.add(scene.part, beside, 2);
  const StretchResult result = scene.run();
  EXPECT_EQ(to_string(result.verdict.reason), "ambiguous") << result.verdict.message;
  EXPECT_EQ(result.verdict.candidates.size(), 2U);
  EXPECT_TRUE(result.path.segments.empty());
}

TEST(OwnPlace, IsNoneOfAnotherPartAmongClamps) {
  Scene scene;
  for (const double side : {-1.0, 1.0})
    scene.add_plate({side * 0.18, 0, 0.06}, 0.1, 0.15);
  const synthetic::Part frame = synthetic::photo_frame();
  const StretchResult result = scene.run(frame, synthetic::path_on(frame, 100));
  EXPECT_EQ(to_string(result.verdict.reason), "wrong_part") << result.verdict.message;
}

TEST(Strangers, OverThePathAreNamedByAreaAndPlace) {
  Scene scene;
  const Eigen::Vector3d over = scene.path.segments[0].waypoints[20].pose.translation();
  const Eigen::Vector3d middle = over + Eigen::Vector3d(0, 0, 0.01);
  scene.add_plate(middle, 0.03, 0.02);
  const StretchResult result = scene.run();
  ASSERT_EQ(to_string(result.verdict.reason), "wrong_part") << result.verdict.message;
  const std::size_t at = result.verdict.message.find("mm off it: ");
  ASSERT_NE(at, std::string::npos) << result.verdict.message;
  double area = 0, x = 0, y = 0, z = 0;
  ASSERT_EQ(std::sscanf(result.verdict.message.c_str() + at,
                        "mm off it: %lf mm2 about (%lf, %lf, %lf)", &area, &x, &y, &z),
            4)
      << result.verdict.message;
  EXPECT_NEAR(area, 600, 120);
  EXPECT_LT((Eigen::Vector3d(x, y, z) - scene.moved * middle).norm(), 0.003);
}
