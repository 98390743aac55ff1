// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Clusters, judged by comparing each point with each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "geometry/clusters.h"
#include "scan_cell_common/errors/errors.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::Cloud;
using Index = KdTree::Index;

/// Points on three crossing sheets and some loose ones, with places that several points share.
Cloud some_points(std::mt19937& random) {
  constexpr float kSide = 0.05F;  // [m]
  std::uniform_real_distribution<float> along(-kSide, kSide);
  Cloud cloud;
  for (int i = 0; i < 1500; ++i) {
    const float a = along(random), b = along(random);
    const pcl::PointXYZ sheets[] = {{a, b, 0}, {a, 0.3F * kSide, b}, {a, b, a + 0.8F * kSide}};
    cloud.push_back(sheets[i % 3]);
    if (i % 10 == 0) cloud.push_back({a, b, along(random)});
    if (i % 50 == 0) cloud.push_back(cloud.back());
  }
  return cloud;
}

/// In the order of the points.
std::vector<std::vector<Index>> clusters_by_pairs(const Cloud& cloud, float gap) {
  std::vector<bool> seen(cloud.size(), false);
  std::vector<std::vector<Index>> found;
  for (Index start = 0; start < cloud.size(); ++start) {
    if (seen[start]) continue;
    std::vector<Index> cluster{start};
    seen[start] = true;
    for (std::size_t next = 0; next < cluster.size(); ++next)
      for (Index i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3f step =
            cloud[i].getVector3fMap() - cloud[cluster[next]].getVector3fMap();
        if (seen[i] || step.squaredNorm() >= gap * gap) continue;
        seen[i] = true;
        cluster.push_back(i);
      }
    std::sort(cluster.begin(), cluster.end());
    found.push_back(cluster);
  }
  return found;
}

TEST(Clusters, AreThoseThatEachPointsNeighboursConnect) {
  std::mt19937 random(3);
  const Cloud cloud = some_points(random);
  std::size_t most = 0;
  for (const float gap : {1e-6F, 5e-4F, 1e-3F, 2e-3F, 3e-3F, 4e-3F, 8e-3F, 0.02F, 1.0F}) {
    const auto expected = clusters_by_pairs(cloud, gap);
    EXPECT_EQ(clusters(cloud, gap), expected) << gap;
    for (const std::vector<Index>& cluster : expected) {
      std::vector<Index> one = cluster_of(cloud, gap, cluster.back());
      std::sort(one.begin(), one.end());
      ASSERT_EQ(one, cluster) << gap;
      if (cluster.front() > 20) break;  // a few will do
    }
    most = std::max(most, expected.size());
  }
  EXPECT_GT(most, cloud.size() / 2) << "the smallest gap connects few";
}

/// Steps along the diagonal, where a grid's cells are longest.
TEST(Clusters, EndWhereAStepIsLongerThanTheGap) {
  constexpr double kGap = 3e-3;  // [m]
  for (const double share : {0.98, 1.02}) {
    Cloud cloud;
    for (int i = 0; i < 20; ++i) {
      const auto along = static_cast<float>(i * share * kGap / std::sqrt(3.0));
      cloud.push_back({along, along, along});
    }
    EXPECT_EQ(clusters(cloud, kGap).size(), share < 1 ? 1u : 20u);
  }
}

/// Between two cells that are full from corner to corner, their middles nearly two gaps apart.
TEST(Clusters, ConnectTheCornersOfFullCells) {
  constexpr double kGap = 3e-3;  // [m]
  const double cell = 0.9999 * kGap / std::sqrt(3.0);
  constexpr double kIn = 2e-8;  // [m] inside its border
  Cloud cloud;
  for (const double along : {kIn, cell - kIn, 2 * cell + kIn, 3 * cell - kIn}) {
    const auto place = static_cast<float>(along);
    cloud.push_back({place, place, place});
  }
  EXPECT_EQ(clusters(cloud, kGap).size(), 1u);
}

TEST(Clusters, OfFarPointsWithASmallGapAreFound) {
  Cloud cloud;
  cloud.push_back({1e4F, 0, 0});
  cloud.push_back({-1e4F, 0, 0});
  cloud.push_back({1e4F, 0, 0});
  EXPECT_EQ(clusters(cloud, 1e-6), (std::vector<std::vector<Index>>{{0, 2}, {1}}));
}

TEST(Clusters, OfPointsThatAreNotFiniteAreRefused) {
  Cloud cloud;
  cloud.push_back({0, std::numeric_limits<float>::quiet_NaN(), 0});
  EXPECT_THROW(clusters(cloud, 1e-3), scan_cell_common::UnusableInput);
  EXPECT_TRUE(clusters(Cloud(), 1e-3).empty());
}

}  // namespace
}  // namespace cloud_preprocess
