// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/filters/statistical_outlier_removal.h>

#include <algorithm>
#include <random>
#include <tuple>

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

bool is_before(const pcl::PointXYZ& a, const pcl::PointXYZ& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// A level face of 50 x 50 mm and a flank 20 mm down from one of its edges.
/// @param face, flank [m] distances between points
Cloud face_and_flank(double face, double flank) {
  Cloud cloud;
  const auto add = [&](double x, double y, double z) {
    cloud.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  };
  for (int i = 0; i * face <= 0.05; ++i) {
    for (int j = 0; j * face <= 0.05; ++j)
      add(i * face, j * face, 0);
  }
  for (int i = 0; i * flank <= 0.05; ++i) {
    for (int j = 1; j * flank <= 0.02; ++j)
      add(0, i * flank, -j * flank);
  }
  return cloud;
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

TEST(OutlierRemoval, RemovesNothingThatPclKeeps) {
  Scene scene;
  scene.add_frame({0, 0, 0.10, 0.08});
  OutlierParameters parameters;
  parameters.neighbours = 9;
  parameters.deviations = 1.5;
  Cloud ours = without_outliers(scene.cloud(), parameters);

  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> filter;
  filter.setInputCloud(scene.cloud().makeShared());
  filter.setMeanK(9);
  filter.setStddevMulThresh(1.5);
  Cloud theirs;
  filter.filter(theirs);
  ASSERT_LT(theirs.size(), scene.cloud().size());
  std::sort(ours.begin(), ours.end(), is_before);
  std::sort(theirs.begin(), theirs.end(), is_before);
  EXPECT_TRUE(std::includes(ours.begin(), ours.end(), theirs.begin(), theirs.end(), is_before));
}

TEST(OutlierRemoval, SparesAFlankThatIsFourTimesSparserThanTheFaceBesideIt) {
  const Cloud cloud = face_and_flank(2.5e-4, 1e-3);
  Cloud scan = cloud;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> along(0, 0.05F), off(3e-3F, 8e-3F);
  constexpr std::size_t kStrays = 100;
  for (std::size_t i = 0; i < kStrays; ++i)
    scan.push_back({along(random), along(random), off(random)});
  const Cloud left = without_outliers(scan);
  const auto over = [](const pcl::PointXYZ& point) { return point.z > 1e-3F; };
  EXPECT_EQ(std::count_if(left.begin(), left.end(), over), 0);
  EXPECT_GE(left.size(), cloud.size() - cloud.size() / 1000);
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
