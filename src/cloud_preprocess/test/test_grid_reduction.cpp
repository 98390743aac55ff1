// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/filters/voxel_grid.h>

#include <cmath>
#include <limits>
#include <random>

#include "cloud_preprocess/grid_reduction.h"
#include "geometry/grid_cells.h"
#include "scan_cell_common/errors/errors.h"

using cloud_preprocess::Cloud;
using cloud_preprocess::GridParameters;
using cloud_preprocess::GridReduction;
using cloud_preprocess::StageReport;
using cloud_preprocess::TracedCloud;
using scan_cell_common::UnusableInput;

namespace {

Cloud random_cloud(int count) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<float> unit(-0.1F, 0.1F);
  Cloud cloud;
  for (int i = 0; i < count; ++i) {
    cloud.push_back({unit(generator), unit(generator), 0.02F * unit(generator)});
  }
  return cloud;
}

Cloud reduced(const Cloud& cloud, const GridParameters& parameters = {}) {
  StageReport report;
  return GridReduction(parameters).run(cloud, report);
}

}  // namespace

TEST(GridReduction, SortsIntoTheCellsOfPclsVoxelGridInItsOrder) {
  const Cloud cloud = random_cloud(100000);
  pcl::VoxelGrid<pcl::PointXYZ> filter;
  filter.setInputCloud(cloud.makeShared());
  filter.setLeafSize(0.002F, 0.002F, 0.0005F);
  Cloud theirs;
  filter.filter(theirs);
  EXPECT_EQ(reduced(cloud).size(), theirs.size());
  const Cloud ours = cloud_preprocess::sort_into_grid(cloud, GridParameters().leaf).means;
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    EXPECT_LT((ours[i].getVector3fMap() - theirs[i].getVector3fMap()).norm(), 1e-6F);
  }
}

TEST(GridReduction, DoesNotShiftASurfaceBesideTheBorderOfItsCells) {
  const double edge = GridParameters().leaf.z();  // a border of cells
  for (const double beside : {0.0, 0.00005, 0.0001, 0.00015, 0.0002, 0.00025, 0.0004}) {
    std::mt19937 generator(5);
    std::uniform_real_distribution<float> across(0, 0.05F);
    std::normal_distribution<float> height(static_cast<float>(20 * edge + beside), 0.0001F);
    Cloud cloud;
    for (int i = 0; i < 40000; ++i)
      cloud.push_back({across(generator), across(generator), height(generator)});
    double sum = 0;
    const Cloud few = reduced(cloud);
    for (const pcl::PointXYZ& point : few)
      sum += point.z;
    EXPECT_NEAR(sum / static_cast<double>(few.size()), 20 * edge + beside, 5e-6) << beside;
  }
}

TEST(GridReduction, ReducesACloudWithAPointFarAwayThatMakesVoxelGridGiveUp) {
  Cloud cloud = random_cloud(20000);
  const std::size_t alone = reduced(cloud).size();
  cloud.push_back({9, -14, 11});
  EXPECT_EQ(reduced(cloud).size(), alone + 1);
}

TEST(GridReduction, TracesEachMeanToTheNearestPointOfItsCell) {
  const Cloud cloud = random_cloud(20000);
  TracedCloud traced(cloud);
  StageReport report;
  GridReduction({}).run(traced, report);
  ASSERT_EQ(traced.sources().size(), traced.cloud().size());
  for (std::size_t i = 0; i < traced.cloud().size(); ++i) {
    const auto mean = traced.cloud()[i].getVector3fMap();
    const auto source = cloud[traced.sources()[i]].getVector3fMap();
    EXPECT_LT((mean - source).norm(), 0.003F) << "the diagonal of a cell";
  }
}

TEST(GridReduction, RefusesAPointBeyondItsGridWithACure) {
  Cloud cloud = random_cloud(10);
  cloud.push_back({0, 0, 1e6F});
  try {
    reduced(cloud);
    FAIL();
  } catch (const UnusableInput& error) {
    EXPECT_NE(error.cure().find("outliers"), std::string::npos);
  }
}

TEST(GridReduction, DropsAndCountsPointsThatAreNotFinite) {
  Cloud cloud = random_cloud(1000);
  const Cloud clean = reduced(cloud);
  cloud[0].x = std::numeric_limits<float>::infinity();
  cloud.insert(cloud.begin() + 500, {0, std::numeric_limits<float>::quiet_NaN(), 0});
  StageReport report;
  const Cloud left = GridReduction({}).run(cloud, report);
  EXPECT_EQ(report.points_in, 1001U);
  EXPECT_EQ(report.non_finite, 2U);
  EXPECT_EQ(report.points_out, left.size());
  for (const pcl::PointXYZ& point : left)
    EXPECT_TRUE(std::isfinite(point.x + point.y + point.z));
}

TEST(GridReduction, RefusesCloudsWithoutAFinitePoint) {
  EXPECT_THROW(reduced(Cloud()), UnusableInput);
  Cloud cloud;
  cloud.push_back({0, std::numeric_limits<float>::quiet_NaN(), 0});
  EXPECT_THROW(reduced(cloud), UnusableInput);
}

TEST(GridReduction, RefusesACellWithoutSize) {
  GridParameters parameters;
  parameters.leaf.y() = 0;
  EXPECT_THROW(GridReduction{parameters}, scan_cell_common::InvalidParameter);
}
