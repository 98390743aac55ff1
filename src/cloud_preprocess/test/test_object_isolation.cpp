// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include <random>

#include "cloud_preprocess/object_isolation.h"
#include "scan_cell_common/errors/errors.h"
#include "scene.h"

using cloud_preprocess::Axis;
using cloud_preprocess::Cloud;
using cloud_preprocess::IsolationParameters;
using cloud_preprocess::Label;
using cloud_preprocess::ObjectIsolation;
using cloud_preprocess::Scene;
using cloud_preprocess::Selection;
using cloud_preprocess::StageReport;
using scan_cell_common::UnusableInput;

namespace {

/// Two boxes side by side along x, 20 mm apart, the larger one (kPart) on the right, and outliers.
Scene two_boxes() {
  Scene scene;
  scene.add_box({-0.06, 0, 0.06, 0.05}, 0.03, Label::kOtherPart);
  scene.add_box({0.03, 0, 0.08, 0.07}, 0.04, Label::kPart);
  scene.add_outliers({0, 0, 0.30, 0.25}, 0.3, 100);
  return scene;
}

Cloud isolated(const Cloud& cloud, const IsolationParameters& parameters) {
  StageReport report;
  return ObjectIsolation(parameters).run(cloud, report);
}

void expect_only(Label label, const Scene& scene, const IsolationParameters& parameters) {
  const Cloud left = isolated(scene.cloud(), parameters);
  for (const Label each : {Label::kPart, Label::kOtherPart, Label::kOutlier}) {
    EXPECT_EQ(scene.share_in(left, each), each == label ? 1.0 : 0.0);
  }
}

}  // namespace

TEST(ObjectIsolation, KeepsTheLargestOfTwoBoxes) {
  expect_only(Label::kPart, two_boxes(), {});
}

TEST(ObjectIsolation, KeepsTheOneNearestToAPoint) {
  IsolationParameters parameters;
  parameters.select = Selection::kNearest;
  parameters.point << -0.1, 0, 0;
  expect_only(Label::kOtherPart, two_boxes(), parameters);
  parameters.point << 0.05, 0.1, 0;
  expect_only(Label::kPart, two_boxes(), parameters);
}

TEST(ObjectIsolation, CountsObjectsAlongAnAxis) {
  IsolationParameters parameters;
  parameters.select = Selection::kIndex;
  expect_only(Label::kOtherPart, two_boxes(), parameters);
  parameters.index = 1;
  expect_only(Label::kPart, two_boxes(), parameters);
  parameters.axis = Axis::kZ;  // the smaller box is the lower one
  expect_only(Label::kPart, two_boxes(), parameters);
}

TEST(ObjectIsolation, SaysHowManyObjectsThereAreWhereTheIndexIsTooLarge) {
  IsolationParameters parameters;
  parameters.select = Selection::kIndex;
  parameters.index = 2;
  try {
    isolated(two_boxes().cloud(), parameters);
    FAIL();
  } catch (const UnusableInput& error) {
    EXPECT_EQ(error.thing(), "isolate: index");
    EXPECT_NE(error.cure().find("there are 2 objects"), std::string::npos);
  }
}

TEST(ObjectIsolation, CutsAtTheLimitsByHand) {
  const Scene scene = two_boxes();
  IsolationParameters parameters;
  parameters.select = Selection::kAll;
  parameters.limits.x_max = -0.02;
  const Cloud left = isolated(scene.cloud(), parameters);
  EXPECT_EQ(scene.share_in(left, Label::kOtherPart), 1.0);
  EXPECT_EQ(scene.share_in(left, Label::kPart), 0.0);
}

TEST(ObjectIsolation, RefusesACloudWithoutAnObject) {
  Scene scene;
  scene.add_outliers({0, 0, 0.30, 0.25}, 0.3, 100);
  EXPECT_THROW(isolated(scene.cloud(), {}), UnusableInput);
}

TEST(ObjectIsolation, JoinsAcrossGapsBelowTheGivenOneOnly) {
  Scene scene;
  scene.add_box({-0.06, 0, 0.06, 0.05}, 0.03, Label::kPart);
  scene.add_box({0.02, 0, 0.06, 0.05}, 0.03, Label::kPart);  // 20 mm beside it
  IsolationParameters parameters;
  parameters.gap = 0.025;
  EXPECT_EQ(isolated(scene.cloud(), parameters).size(), scene.cloud().size());
  parameters.gap = 0.015;
  EXPECT_EQ(scene.share_in(isolated(scene.cloud(), parameters), Label::kPart), 0.5);
}

TEST(ObjectIsolation, FindsTheLargestClusterOfPcl) {
  // Blobs whose gaps are all clearly larger or clearly smaller than the requested one.
  Cloud cloud;
  std::mt19937 generator(3);
  std::normal_distribution<float> normal(0, 0.004F);
  std::uniform_int_distribution<int> place(0, 5);
  for (int blob = 0; blob < 30; ++blob) {
    const float x = 0.1F * static_cast<float>(place(generator));
    const float y = 0.1F * static_cast<float>(place(generator));
    for (int i = 0; i < 100 + blob; ++i) {
      cloud.push_back({x + normal(generator), y + normal(generator), normal(generator)});
    }
  }
  IsolationParameters parameters;
  parameters.gap = 0.02;
  const Cloud ours = isolated(cloud, parameters);

  const auto input = cloud.makeShared();
  const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  tree->setInputCloud(input);
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(0.02);
  extraction.setSearchMethod(tree);
  extraction.setInputCloud(input);
  std::vector<pcl::PointIndices> clusters;
  extraction.extract(clusters);
  ASSERT_GT(clusters.size(), 5U);
  const Cloud theirs(cloud, clusters.front().indices);
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    EXPECT_EQ(ours[i].getVector3fMap(), theirs[i].getVector3fMap());
  }
}
