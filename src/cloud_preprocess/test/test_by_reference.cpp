// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cloud_preprocess/clean.h"
#include "scan_cell_common/errors/errors.h"
#include "scene.h"

using namespace cloud_preprocess;

namespace {

const Scene::Rectangle kLargeTable{0, 0, 0.40, 0.25};
const Scene::Rectangle kPart{-0.10, 0, 0.06, 0.08};
const Scene::Rectangle kOther{0.08, 0, 0.12, 0.10};
constexpr double kHigh = 0.03;  // [m]

bool is_on(const pcl::PointXYZ& point, const Scene::Rectangle& box) {
  return box.inside(point.x, point.y) > -0.001;
}

/// A finder that explains what stands in given rectangles, and says that the reference lies there.
class KnownPlaces final : public ReferenceFinder {
 public:
  explicit KnownPlaces(std::vector<Scene::Rectangle> places) : places_(std::move(places)) {}

  void load(const std::string& /*file*/, double /*metres_per_unit*/) override {}

  ReferenceSearch find(const Cloud& scene,
                       const std::vector<std::vector<std::uint32_t>>& /*objects*/) const override {
    ReferenceSearch search{{}, places_.empty() ? "nothing like it" : ""};
    for (const Scene::Rectangle& place : places_) {
      FoundReference& found = search.found.emplace_back();
      for (std::uint32_t i = 0; i < scene.size(); ++i) {
        if (!is_on(scene[i], place) || scene[i].z > kHigh + 0.001) continue;
        found.explained.push_back(i);
        found.laid.push_back(scene[i]);
      }
    }
    return search;
  }

 private:
  std::vector<Scene::Rectangle> places_;
};

Scene part_and_larger_thing() {
  Scene scene;
  scene.add_floor(kLargeTable, {kPart, kOther});
  scene.add_box(kPart, kHigh);
  scene.add_box(kOther, kHigh, Label::kOtherPart);
  return scene;
}

CleanParameters by_reference(std::shared_ptr<const ReferenceFinder> finder) {
  CleanParameters parameters;
  parameters.outliers.automatic = false;
  parameters.isolate.select = Selection::kReference;
  parameters.isolate.reference = "part.ply";
  parameters.isolate.finder = std::move(finder);
  parameters.grid.reset();
  return parameters;
}

Cloud cleaned(const Scene& scene, const std::vector<Scene::Rectangle>& places, std::string& said) {
  std::vector<StageReport> reports;
  Cloud left = clean(scene.cloud(), by_reference(std::make_shared<KnownPlaces>(places)), reports);
  said = reports.back().message;
  return left;
}

std::string refusal(const Scene& scene, const std::vector<Scene::Rectangle>& places) {
  std::string said;
  try {
    cleaned(scene, places, said);
  } catch (const scan_cell_common::UnusableInput& error) {
    return error.what();
  }
  return "not refused: " + said;
}

void expect_has(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << " not in: " << text;
}

}  // namespace

TEST(ByReference, WhatItExplainsIsKeptNotTheLargest) {
  const Scene scene = part_and_larger_thing();
  std::string said;
  const Cloud left = cleaned(scene, {kPart}, said);
  EXPECT_EQ(scene.share_in(left, Label::kPart), 1.0);
  EXPECT_EQ(scene.share_in(left, Label::kOtherPart), 0.0);
  EXPECT_EQ(scene.share_in(left, Label::kFloor), 0.0);
  expect_has(said, "what 'part.ply' explains kept");
}

TEST(ByReference, WhatStandsOverThePartStays) {
  Scene scene = part_and_larger_thing();
  const Scene::Rectangle beam{kPart.x, kPart.y + 0.06, 0.02, 0.16};  // half of it beside the part
  for (double x = -0.5; x < 0.5; x += 0.05) {
    for (double y = -0.5; y < 0.5; y += 0.005)
      scene.add(beam.x + x * beam.width, beam.y + y * beam.depth, 0.08, Label::kOutlier);
  }
  std::string said;
  const Cloud left = cleaned(scene, {kPart}, said);
  std::size_t over = 0, beside = 0;
  for (const pcl::PointXYZ& point : left) {
    if (point.z < 0.07) continue;
    ++(kPart.inside(point.x, point.y) > -0.006 ? over : beside);
  }
  EXPECT_GE(over, 700U);  // 0.06 of 0.16 m along y of 4000
  EXPECT_EQ(beside, 0U);
}

TEST(ByReference, WhatIsNearerThanTheGapStays) {
  Scene scene = part_and_larger_thing();
  for (double away = 0.001; away < 0.03; away += 0.0005) {
    for (double y = -0.02; y < 0.02; y += 0.0005)
      scene.add(kPart.x - kPart.width / 2 - away, y, 0.02, Label::kOutlier);
  }
  std::string said;
  const Cloud left = cleaned(scene, {kPart}, said);
  EXPECT_NEAR(scene.share_in(left, Label::kOutlier), 0.33, 0.03);  // 10 of 30 mm
}

TEST(ByReference, NothingExplainedIsRefusedWithThePlacesOfTheObjects) {
  const std::string said = refusal(part_and_larger_thing(), {});
  expect_has(said, "isolate: reference: 'part.ply' explains none of 2 objects (");
  expect_has(said, "points about (0.08");
  expect_has(said, "points about (-0.10");
  expect_has(said, "for the largest: nothing like it;");
}

TEST(ByReference, TwoAlikeAreRefusedWithBothPlaces) {
  const std::string said = refusal(part_and_larger_thing(), {kPart, kOther});
  expect_has(said, "'part.ply' explains 2 objects: ");
  expect_has(said, "points about (-0.10");
  expect_has(said, "points about (0.08");
  expect_has(said, "isolate/select to nearest");
}

TEST(ByReference, TheOtherObjectsAreCloudsOfTheirOwnToo) {
  const Scene scene = part_and_larger_thing();
  TracedCloud cloud(scene.cloud());
  std::vector<StageReport> reports;
  std::vector<TracedCloud> objects;
  clean(cloud, by_reference(std::make_shared<KnownPlaces>(std::vector{kPart})), reports, objects);
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(scene.share_in(objects[0].cloud(), Label::kPart), 1.0);
  EXPECT_EQ(scene.share_in(objects[1].cloud(), Label::kOtherPart), 1.0);
}

TEST(ByReference, IsRefusedByNameWithoutTheReference) {
  CleanParameters parameters = by_reference(std::make_shared<KnownPlaces>(std::vector{kPart}));
  parameters.isolate.reference.clear();
  std::vector<StageReport> reports;
  try {
    clean(Cloud(), parameters, reports);
    FAIL() << "not refused";
  } catch (const scan_cell_common::InvalidParameter& error) {
    EXPECT_EQ(error.thing(), "reference");
  }
  EXPECT_THROW(clean(Cloud(), by_reference(nullptr), reports), scan_cell_common::InvalidParameter);
}
