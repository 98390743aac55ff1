// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <random>

#include "cloud_preprocess/floor_removal.h"
#include "scan_cell_common/errors/errors.h"
#include "scene.h"

using cloud_preprocess::Cloud;
using cloud_preprocess::FloorParameters;
using cloud_preprocess::FloorRemoval;
using cloud_preprocess::kBox;
using cloud_preprocess::kFrame;
using cloud_preprocess::Label;
using cloud_preprocess::Scene;
using cloud_preprocess::StageReport;
using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;

namespace {

const Scene::Rectangle kTable{0, 0, 0.30, 0.25};

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

void expect_only_the_floor_is_gone(const Scene& scene, const FloorParameters& parameters = {}) {
  const Cloud left = without_floor(scene.cloud(), parameters);
  EXPECT_EQ(scene.share_in(left, Label::kFloor), 0.0);
  EXPECT_EQ(scene.share_in(left, Label::kPart), 1.0);
}

/// Orientations: a few obvious ones, then random ones with a fixed seed.
std::vector<Eigen::Quaternionf> orientations() {
  std::vector<Eigen::Quaternionf> all;
  for (const float degrees : {10.0F, 30.0F, 90.0F, 180.0F, 270.0F}) {
    const float angle = degrees * static_cast<float>(M_PI / 180);
    all.emplace_back(Eigen::AngleAxisf(angle, Eigen::Vector3f::UnitX()));
    all.emplace_back(Eigen::AngleAxisf(angle, Eigen::Vector3f::UnitY()));
  }
  std::mt19937 generator(11);
  std::normal_distribution<float> normal;
  for (int i = 0; i < 14; ++i) {
    all.push_back(Eigen::Quaternionf(normal(generator), normal(generator), normal(generator),
                                     normal(generator))
                      .normalized());
  }
  return all;
}

Scene turned(const Eigen::Quaternionf& by) {
  Scene scene = table_with_frame_and_box();
  scene.move(Eigen::Translation3f(0.4F, -0.2F, 0.7F) * by);
  return scene;
}

std::string refusal(const Cloud& cloud, const FloorParameters& parameters = {}) {
  try {
    without_floor(cloud, parameters);
  } catch (const UnusableInput& error) {
    return error.what();
  }
  return "nothing";
}

Scene two_boxes_without_floor() {
  Scene scene;
  scene.add_box(kBox, 0.05);
  scene.add_box({-0.06, 0, 0.08, 0.06}, 0.03, Label::kOtherPart);
  return scene;
}

}  // namespace

TEST(FloorRemoval, RemovesTheFloorAndNothingOfTheParts) {
  expect_only_the_floor_is_gone(table_with_frame_and_box());
}

TEST(FloorRemoval, FollowsAFloorThatLeans) {
  for (const float degrees : {-1.0F, 1.0F, 4.0F, -10.0F, 10.0F}) {
    Scene scene = table_with_frame_and_box();
    const Eigen::Vector3f axis(1, 0.5F, 0);
    scene.move(Eigen::Translation3f(0.4F, -0.2F, 0.7F) *
               Eigen::AngleAxisf(degrees * static_cast<float>(M_PI / 180), axis.normalized()));
    SCOPED_TRACE(degrees);
    expect_only_the_floor_is_gone(scene);
  }
}

TEST(FloorRemoval, FindsTheFloorAcrossADirectionThatIsRoughlyGiven) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const Eigen::Quaternionf& by : orientations()) {
    SCOPED_TRACE(by.coeffs().transpose());
    const Eigen::Vector3d off(unit(generator), unit(generator), unit(generator));
    FloorParameters parameters;
    parameters.up = 3 * ((by * Eigen::Vector3f::UnitZ()).cast<double>() + 0.1 * off);
    expect_only_the_floor_is_gone(turned(by), parameters);
  }
}

TEST(FloorRemoval, FindsATableInAnyDirectionByItself) {
  FloorParameters parameters;
  parameters.any_direction = true;
  for (const Eigen::Quaternionf& by : orientations()) {
    SCOPED_TRACE(by.coeffs().transpose());
    expect_only_the_floor_is_gone(turned(by), parameters);
  }
}

TEST(FloorRemoval, RefusesATableInAnotherDirectionAndGivesTheOneThatFindsIt) {
  for (const Eigen::Quaternionf& by : orientations()) {
    SCOPED_TRACE(by.coeffs().transpose());
    const float cosine = (by * Eigen::Vector3f::UnitZ()).z();
    if (cosine > std::cos(0.3F)) continue;  // found
    const Scene scene = turned(by);
    const std::string said = refusal(scene.cloud());
    const std::size_t at = said.find("--up ");
    ASSERT_NE(at, std::string::npos) << said;
    FloorParameters parameters;
    ASSERT_EQ(std::sscanf(said.c_str() + at, "--up %lf,%lf,%lf", &parameters.up.x(),
                          &parameters.up.y(), &parameters.up.z()),
              3)
        << said;
    expect_only_the_floor_is_gone(scene, parameters);
  }
}

TEST(FloorRemoval, RefusesATableOnItsSideWhereTheLowestFaceOfThePartReachesTheEdge) {
  const Scene::Rectangle at_edge{0.118, 0, 0.06, 0.20};
  Scene scene;
  scene.add_floor(kTable, {at_edge, kFrame});
  scene.add_box(at_edge, 0.08);
  scene.add_frame(kFrame);
  for (const float degrees : {90.0F, 180.0F, 270.0F}) {
    Scene moved = scene;
    moved.move(Eigen::Affine3f(
        Eigen::AngleAxisf(degrees * static_cast<float>(M_PI / 180), Eigen::Vector3f::UnitY())));
    EXPECT_NE(refusal(moved.cloud()).find("--up"), std::string::npos) << degrees;
  }
}

TEST(FloorRemoval, RefusesSeveralObjectsWhereNoFloorIsFound) {
  const std::string said = refusal(two_boxes_without_floor().cloud());
  EXPECT_NE(said.find("2 objects"), std::string::npos) << said;
  EXPECT_NE(said.find("--up"), std::string::npos) << said;
  EXPECT_NE(said.find("--floor off"), std::string::npos) << said;
}

TEST(FloorRemoval, TakesSeveralObjectsWhereALimitHasCutTheFloorAway) {
  FloorParameters parameters;
  parameters.limits.z_min = 0.005;
  Scene scene = two_boxes_without_floor();
  scene.add_floor(kTable, {});
  EXPECT_EQ(refusal(scene.cloud(), parameters), "nothing");
  parameters.limits.z_min = -0.5;  // cuts nothing
  EXPECT_NE(refusal(two_boxes_without_floor().cloud(), parameters), "nothing");
}

TEST(FloorRemoval, PrintsNothing) {
  Scene scene = table_with_frame_and_box();
  scene.move(Eigen::Affine3f(Eigen::AngleAxisf(0.17F, Eigen::Vector3f::UnitX())));
  Cloud coarse;  // on a grid of 1 mm, where many points are collinear, or the same
  for (pcl::PointXYZ point : scene.cloud()) {
    for (int axis = 0; axis < 3; ++axis)
      point.data[axis] = 1e-3F * std::round(1e3F * point.data[axis]);
    coarse.push_back(point);
  }
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  without_floor(scene.cloud());
  refusal(coarse);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
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

TEST(FloorRemoval, TakesNoSideOfABoxForATable) {
  FloorParameters parameters;
  parameters.any_direction = true;
  for (const double height : {0.01, 0.05, 0.2}) {
    for (const float angle : {0.4F, 1.2F, 2.5F}) {
      Scene box;
      box.add_box(kBox, height);
      box.move(Eigen::Affine3f(Eigen::AngleAxisf(angle, Eigen::Vector3f(1, 2, 3).normalized())));
      EXPECT_EQ(without_floor(box.cloud(), parameters).size(), box.cloud().size()) << height;
      EXPECT_EQ(without_floor(box.cloud()).size(), box.cloud().size()) << height;
    }
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
  FloorParameters nowhere;
  nowhere.up = Eigen::Vector3d::Zero();
  EXPECT_EQ(refused(nowhere), "up");
  FloorParameters not_a_number;
  not_a_number.limits.x_max = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused(not_a_number), "x_max");
}
