// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>

#include "cloud_preprocess/floor_removal.h"
#include "scan_cell_common/errors.h"
#include "scene.h"

using cloud_preprocess::Cloud;
using cloud_preprocess::FloorParameters;
using cloud_preprocess::FloorRemoval;
using cloud_preprocess::Label;
using cloud_preprocess::Scene;
using cloud_preprocess::StageReport;
using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;

namespace {

const Scene::Rectangle kTable{0, 0, 0.30, 0.25};
const Scene::Rectangle kFrame{-0.06, 0, 0.15, 0.12};
const Scene::Rectangle kBox{0.08, 0, 0.06, 0.08};

Scene table_with_frame_and_box() {
  Scene scene;
  scene.add_floor(kTable, {kFrame, kBox});
  scene.add_frame(kFrame);
  scene.add_box(kBox, 0.05);
  scene.add_outliers({0, 0, 0.30, 0.25}, 0.3, 150);
  scene.add_outliers({0, 0, 0.30, 0.25}, -0.1, 150);  // below the floor
  return scene;
}

Cloud without_floor(const Cloud& cloud, FloorParameters parameters = {}) {
  StageReport report;
  return FloorRemoval(parameters).run(cloud, report);
}

std::string message(const Cloud& cloud) {
  StageReport report;
  FloorRemoval(FloorParameters{}).run(cloud, report);
  return report.message;
}

void expect_only_the_floor_is_gone(const Scene& scene) {
  const Cloud left = without_floor(scene.cloud());
  EXPECT_EQ(scene.share_in(left, Label::kFloor), 0.0);
  EXPECT_EQ(scene.share_in(left, Label::kPart), 1.0);
}

}  // namespace

TEST(FloorRemoval, RemovesTheFloorAndNothingOfTheParts) {
  expect_only_the_floor_is_gone(table_with_frame_and_box());
}

TEST(FloorRemoval, FollowsAFloorThatLeans) {
  for (const float degrees : {-1.0F, 1.0F, 4.0F}) {
    Scene scene = table_with_frame_and_box();
    const Eigen::Vector3f axis(1, 0.5F, 0);
    scene.move(Eigen::Translation3f(0.4F, -0.2F, 0.7F) *
               Eigen::AngleAxisf(degrees * static_cast<float>(M_PI / 180), axis.normalized()));
    SCOPED_TRACE(degrees);
    expect_only_the_floor_is_gone(scene);
  }
}

TEST(FloorRemoval, LeavesTheTopOfABoxThatIsLargerThanTheFloorInSight) {
  const Scene::Rectangle large{0, 0, 0.26, 0.22};
  Scene scene;
  scene.add_floor({0, 0, 0.30, 0.25}, {large});
  scene.add_box(large, 0.04);
  ASSERT_GT(scene.count(Label::kPart), 4 * scene.count(Label::kFloor));
  expect_only_the_floor_is_gone(scene);
}

TEST(FloorRemoval, RemovesNothingWhereThereIsNoFloor) {
  for (const double height : {0.01, 0.05, 0.2}) {
    Scene box;
    box.add_box(kBox, height);
    EXPECT_EQ(without_floor(box.cloud()).size(), box.cloud().size()) << height;
    EXPECT_NE(message(box.cloud()).find("no floor found"), std::string::npos);
  }
}

TEST(FloorRemoval, LeavesTheFlatInsideAFrameWithoutFloor) {
  Scene scene;
  scene.add_frame(kFrame);
  EXPECT_EQ(without_floor(scene.cloud()).size(), scene.cloud().size());
}

TEST(FloorRemoval, TakesTheMarginAboveTheFloorAlong) {
  Scene scene;
  scene.add_floor(kTable, {});
  scene.add(0, 0, 0.0045, Label::kPart);
  scene.add(0, 0, 0.0055, Label::kPart);
  FloorParameters parameters;
  parameters.margin = 0.005;
  EXPECT_EQ(without_floor(scene.cloud(), parameters).size(), 1U);
}

TEST(FloorRemoval, RefusesACloudOfFloorAlone) {
  Scene scene;
  scene.add_floor(kTable, {});
  EXPECT_THROW(without_floor(scene.cloud()), UnusableInput);
}

TEST(FloorRemoval, CutsAtTheLimitsByHand) {
  const Scene scene = table_with_frame_and_box();
  FloorParameters parameters;
  parameters.automatic = false;
  parameters.limits.z_min = 0.010;
  parameters.limits.z_max = 0.020;
  const Cloud left = without_floor(scene.cloud(), parameters);
  std::size_t between = 0;
  for (const pcl::PointXYZ& point : scene.cloud())
    between += point.z >= 0.010 && point.z <= 0.020 ? 1 : 0;
  EXPECT_EQ(left.size(), between);
}

TEST(FloorRemoval, NamesTheCloudsBoundsWhereTheLimitsLeaveNothing) {
  FloorParameters parameters;
  parameters.limits.z_min = 7;
  try {
    without_floor(table_with_frame_and_box().cloud(), parameters);
    FAIL();
  } catch (const UnusableInput& error) {
    EXPECT_EQ(error.thing(), "floor: limits");
    EXPECT_NE(error.cure().find("z -0.09"), std::string::npos) << error.cure();
  }
}

TEST(FloorRemoval, GivesTheSameBytesAgain) {
  const Scene scene = table_with_frame_and_box();
  const Cloud first = without_floor(scene.cloud());
  const Cloud second = without_floor(scene.cloud());
  ASSERT_EQ(first.size(), second.size());
  EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(first[0])), 0);
}

TEST(FloorRemoval, RefusesBadParametersByName) {
  const auto refused = [](const FloorParameters& parameters) -> std::string {
    try {
      FloorRemoval stage(parameters);
    } catch (const InvalidParameter& error) {
      return error.thing();
    }
    return "nothing";
  };
  FloorParameters margin;
  margin.margin = -0.001;
  EXPECT_EQ(refused(margin), "margin");
  FloorParameters limits;
  limits.limits.z_min = 0.1;
  limits.limits.z_max = 0.0;
  EXPECT_EQ(refused(limits), "z_min");
  FloorParameters not_a_number;
  not_a_number.limits.x_max = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused(not_a_number), "x_max");
}
