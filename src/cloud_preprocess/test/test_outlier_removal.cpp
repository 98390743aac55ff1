// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/filters/statistical_outlier_removal.h>

#include "cloud_preprocess/outlier_removal.h"
#include "scan_cell_common/errors/errors.h"
#include "scene.h"

using cloud_preprocess::Cloud;
using cloud_preprocess::kBox;
using cloud_preprocess::kFrame;
using cloud_preprocess::Label;
using cloud_preprocess::OutlierParameters;
using cloud_preprocess::OutlierRemoval;
using cloud_preprocess::Scene;
using cloud_preprocess::StageReport;

namespace {

Scene parts_with_outliers() {
  Scene scene;
  scene.add_frame(kFrame);
  scene.add_box(kBox, 0.05);
  scene.add_outliers({0, 0, 0.30, 0.25}, 0.3, 200);
  return scene;
}

Cloud without_outliers(const Cloud& cloud, OutlierParameters parameters = {}) {
  StageReport report;
  return OutlierRemoval(parameters).run(cloud, report);
}

}  // namespace

TEST(OutlierRemoval, RemovesOutliersAndSparesTheParts) {
  const Scene scene = parts_with_outliers();
  const Cloud left = without_outliers(scene.cloud());
  EXPECT_EQ(scene.share_in(left, Label::kOutlier), 0.0);
  EXPECT_GE(scene.share_in(left, Label::kPart), 0.9999);
}

TEST(OutlierRemoval, SparesTheEdgesOfACleanCloud) {
  Scene scene;
  scene.add_frame(kFrame);
  scene.add_box(kBox, 0.05);
  EXPECT_GE(scene.share_in(without_outliers(scene.cloud()), Label::kPart), 0.99);
}

TEST(OutlierRemoval, SeesOutliersBesideOnesThatAreFarAway) {
  Scene scene = parts_with_outliers();
  scene.add(0, 0, 1000, Label::kOutlier);
  scene.add(800, -300, 0, Label::kOutlier);
  const Cloud left = without_outliers(scene.cloud());
  EXPECT_EQ(scene.share_in(left, Label::kOutlier), 0.0);
  EXPECT_GE(scene.share_in(left, Label::kPart), 0.9999);
}

TEST(OutlierRemoval, DoesAsPclWhereNothingIsFarAway) {
  Scene scene;
  scene.add_frame({0, 0, 0.10, 0.08});
  OutlierParameters parameters;
  parameters.neighbours = 9;
  parameters.deviations = 1.5;
  const Cloud ours = without_outliers(scene.cloud(), parameters);

  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> filter;
  filter.setInputCloud(scene.cloud().makeShared());
  filter.setMeanK(9);
  filter.setStddevMulThresh(1.5);
  Cloud theirs;
  filter.filter(theirs);
  ASSERT_LT(theirs.size(), scene.cloud().size());
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    EXPECT_EQ(ours[i].getVector3fMap(), theirs[i].getVector3fMap());
  }
}

TEST(OutlierRemoval, CutsAtTheLimitsByHand) {
  const Scene scene = parts_with_outliers();
  OutlierParameters parameters;
  parameters.automatic = false;
  parameters.limits.x_min = 0.0;
  parameters.limits.y_max = 0.01;
  parameters.limits.z_max = 0.04;
  const Cloud left = without_outliers(scene.cloud(), parameters);
  std::size_t inside = 0;
  for (const pcl::PointXYZ& point : scene.cloud()) {
    inside += point.x >= 0 && point.y <= 0.01 && point.z <= 0.04 ? 1 : 0;
  }
  EXPECT_EQ(left.size(), inside);
}

TEST(OutlierRemoval, StandsCloudsOfOnePointAndOfEqualPoints) {
  Cloud cloud;
  cloud.push_back({1, 2, 3});
  EXPECT_EQ(without_outliers(cloud).size(), 1U);
  for (int i = 0; i < 50; ++i)
    cloud.push_back({1, 2, 3});
  EXPECT_EQ(without_outliers(cloud).size(), 51U);
}
