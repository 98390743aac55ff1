// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cloud_preprocess/clean.h"
#include "scene.h"

using namespace cloud_preprocess;

namespace {

constexpr double kRib = 0.03;     // [m] height of the piece on the left
constexpr double kPlate = 0.008;  // of the one on the right

/// A rib, a plate, and a `gap` between them, of which `shadow` [m] right of the rib was not seen.
/// Outside the shadow, the floor in the gap was seen.
Scene torn_part(double gap, double shadow, Label plate = Label::kPart, double rib = kRib) {
  const Scene::Rectangle left{-0.05, 0, 0.06, 0.08};
  const Scene::Rectangle right{-0.02 + gap + 0.03, 0, 0.06, 0.08};
  const Scene::Rectangle dark{-0.02 + shadow / 2, 0, shadow, 0.08};
  Scene scene;
  scene.add_floor({0, 0, 0.30, 0.25}, {left, right, dark});
  scene.add_box(left, rib);
  scene.add_box(right, kPlate, plate);
  return scene;
}

/// @param[out] said message of the stage isolate
Cloud isolated(const Scene& scene, const IsolationParameters& isolate, std::string& said) {
  CleanParameters parameters;
  parameters.outliers.automatic = false;
  parameters.isolate = isolate;
  parameters.grid.reset();
  std::vector<StageReport> reports;
  Cloud left = clean(scene.cloud(), parameters, reports);
  said = reports.back().message;
  return left;
}

double share(const Scene& scene, Label label, const IsolationParameters& isolate = {}) {
  std::string said;
  return scene.share_in(isolated(scene, isolate, said), label);
}

}  // namespace

TEST(Shadows, TearNoPartApart) {
  const Scene scene = torn_part(0.03, 0.03);
  std::string said;
  const Cloud left = isolated(scene, {}, said);
  EXPECT_EQ(scene.share_in(left, Label::kPart), 1.0);
  EXPECT_EQ(scene.share_in(left, Label::kFloor), 0.0);
  EXPECT_NE(said.find("1 piece joined across what was not seen"), std::string::npos) << said;
}

TEST(Shadows, TearNoPartApartOnALeaningTable) {
  Scene scene = torn_part(0.03, 0.03);
  scene.move(Eigen::Affine3f(Eigen::AngleAxisf(0.2F, Eigen::Vector3f::UnitY())));
  EXPECT_EQ(share(scene, Label::kPart), 1.0);
}

TEST(Shadows, JoinNoNeighbourBehindFloorThatIsSeen) {
  EXPECT_EQ(share(torn_part(0.045, 0.02, Label::kOtherPart), Label::kOtherPart), 0.0);
}

TEST(Shadows, ReachNoFurtherThanThePartIsHigh) {
  const double low = 0.01;  // its shadow cannot be 30 mm long
  const Scene scene = torn_part(0.03, 0.03, Label::kOtherPart, low);
  EXPECT_EQ(share(scene, Label::kOtherPart), 0.0);
}

TEST(Shadows, AreLeftAloneWhereThatIsAskedFor) {
  IsolationParameters isolate;
  isolate.across_shadows = false;
  EXPECT_EQ(share(torn_part(0.03, 0.03, Label::kOtherPart), Label::kOtherPart, isolate), 0.0);
}

TEST(Shadows, AreNotGuessedWhereNoFloorWasSeen) {
  Scene scene;
  scene.add_box({-0.05, 0, 0.06, 0.08}, kRib);
  scene.add_box({0.04, 0, 0.06, 0.08}, kPlate, Label::kOtherPart);
  CleanParameters parameters;
  parameters.floor.automatic = false;
  parameters.outliers.automatic = false;
  parameters.grid.reset();
  std::vector<StageReport> reports;
  EXPECT_EQ(scene.share_in(clean(scene.cloud(), parameters, reports), Label::kOtherPart), 0.0);
}
