// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numeric>

#include "scan_cell_common/geometry/cell_means.h"

namespace scan_cell_common {
namespace {

using Eigen::Vector3d;

CellMeans means_of(const std::vector<Vector3d>& points) {
  const Grid grid{Vector3d(2, 2, 0.5), {2, 1, 0}, 1e6};
  const auto position = [&points](std::size_t i) { return points[i]; };
  return joined_means(sums_of_cells(sort_into_grid(points.size(), position, grid), position), grid);
}

TEST(CellMeans, OfCellsWhoseMeansAreFarApartAreAsTheyAre) {
  const CellMeans means = means_of({{0.5, 1, 0.25}, {1.5, 1, 0.25}, {3, 1, 0.25}, {1, 1, 0.75}});
  ASSERT_EQ(means.means.size(), 3U);
  EXPECT_EQ(means.means[0], Vector3d(1, 1, 0.25));
  EXPECT_EQ(means.mean_of_cell, (std::vector<std::uint32_t>{0, 1, 2}));
}

/// `across` by `across` points in a column of cells, from x and y 0 to 2.
void add_layer(int across, double z, std::vector<Vector3d>& points) {
  for (int x = 0; x < across; ++x)
    for (int y = 0; y < across; ++y)
      points.emplace_back((x + 0.5) * 2 / across, (y + 0.5) * 2 / across, z);
}

TEST(CellMeans, OfASurfaceOnBothSidesOfABorderAreOneWithAllPointsAlike) {
  std::vector<Vector3d> points;
  add_layer(4, 0.55, points);
  add_layer(2, 0.45, points);  // below the border at 0.5
  const CellMeans means = means_of(points);
  ASSERT_EQ(means.means.size(), 1U);
  EXPECT_TRUE(means.means[0].isApprox(Vector3d(1, 1, (16 * 0.55 + 4 * 0.45) / 20)));
}

TEST(CellMeans, OfAFewPointsThatNoiseCarriedAcrossAreWithTheOthersWhereverTheyLie) {
  std::vector<Vector3d> points = {{0.1, 1.9, 0.3}};
  add_layer(4, 0.7, points);
  const CellMeans means = means_of(points);
  ASSERT_EQ(means.means.size(), 1U);
  EXPECT_TRUE(means.means[0].isApprox((Vector3d(0.1, 1.9, 0.3) + 16 * Vector3d(1, 1, 0.7)) / 17));
}

TEST(CellMeans, OfAWallBelowAnEdgeAreItsOwn) {
  std::vector<Vector3d> points;
  add_layer(4, 0.55, points);
  for (int y = 0; y < 4; ++y)
    points.emplace_back(1.95, 0.25 + 0.5 * y, 0.4);
  EXPECT_EQ(means_of(points).means.size(), 2U);
}

TEST(CellMeans, OfTheEndOfASurfaceThatFillsTheNextCellAreItsOwn) {
  std::vector<Vector3d> points;
  add_layer(8, 0.25, points);
  for (int y = 0; y < 8; ++y)
    points.emplace_back(2.1, 0.1 + 0.25 * y, 0.25);
  EXPECT_EQ(means_of(points).means.size(), 2U);
}

}  // namespace
}  // namespace scan_cell_common
