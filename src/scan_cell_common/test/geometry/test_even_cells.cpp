// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "scan_cell_common/geometry/even_cells.h"

namespace scan_cell_common {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

const Grid kGrid{Vector3d(2, 2, 0.5), {2, 1, 0}, 1e6};

/// Means of the cells, in order.
Points means_of(const Points& points) {
  const auto position = [&points](std::size_t i) { return points[i]; };
  Points means;
  const auto entries =
      with_even_cells(sort_into_grid(points.size(), position, kGrid), position, kGrid);
  for_each_cell(entries, [&](auto begin, auto end) {
    means.emplace_back(Vector3d::Zero());
    for (auto each = begin; each != end; ++each)
      means.back() += position(each->point) / (end - begin);
  });
  return means;
}

/// Adds `across` by `across` points in a column of cells, with x and y from 0 to 2.
void add_layer(int across, double z, Points& points) {
  for (int x = 0; x < across; ++x)
    for (int y = 0; y < across; ++y)
      points.emplace_back((x + 0.5) * 2 / across, (y + 0.5) * 2 / across, z);
}

bool lists(const Points& means, const Vector3d& mean) {
  return std::any_of(means.begin(), means.end(),
                     [&mean](const Vector3d& each) { return each.isApprox(mean); });
}

TEST(EvenCells, WhoseMeansAreFarApartKeepTheirPoints) {
  const Points means = means_of({{0.5, 1, 0.25}, {1.5, 1, 0.25}, {3, 1, 0.25}, {1, 1, 0.75}});
  ASSERT_EQ(means.size(), 3U);
  EXPECT_EQ(means[0], Vector3d(1, 1, 0.25));
}

TEST(EvenCells, OfASurfaceOnBothSidesOfTheirBorderHaveItsHeightSideBySide) {
  Points points;
  add_layer(4, 0.55, points);
  for (const double x : {0.01, 1.99})  // below the border at 0.5
    for (const double y : {0.5, 1.5})
      points.emplace_back(x, y, 0.45);
  const Points means = means_of(points);
  ASSERT_EQ(means.size(), 2U);
  const double height = (8 * 0.55 + 2 * 0.45) / 10;
  const double x = (4 * 0.25 + 4 * 0.75 + 2 * 0.01) / 10;
  EXPECT_TRUE(lists(means, {x, 1, height})) << means[0].transpose();
  EXPECT_TRUE(lists(means, {2 - x, 1, height})) << means[1].transpose();
}

TEST(EvenCells, OfAFewPointsThatNoiseCarriedAcrossGetAsManyAsTheOthersWhereverThoseLie) {
  Points points = {{0.1, 0.2, 0.3}};
  for (int i = 0; i < 9; ++i)
    points.emplace_back(0.2 + 0.2 * i, 0.1 + 0.2 * (i % 3), 0.7);
  const Points means = means_of(points);
  ASSERT_EQ(means.size(), 2U);
  const double height = (4 * 0.7 + 0.3) / 5;
  EXPECT_NEAR(std::min(means[0].z(), means[1].z()), height, 1e-9);
  EXPECT_NEAR(std::max(means[0].z(), means[1].z()), 0.7, 1e-9);
}

TEST(EvenCells, LeavePointsInOnePlaceTogetherSoThatCopiesChangeNothing) {
  Points points = {{0.1, 0.2, 0.3}};
  for (int i = 0; i < 9; ++i)
    points.emplace_back(0.2 + 0.2 * i, 0.1 + 0.2 * (i % 3), 0.7);
  const Points once = means_of(points);
  Points thrice;
  for (int copy = 0; copy < 3; ++copy)
    thrice.insert(thrice.end(), points.begin(), points.end());
  const Points means = means_of(thrice);
  ASSERT_EQ(means.size(), once.size());
  for (std::size_t i = 0; i < once.size(); ++i)
    EXPECT_TRUE(means[i].isApprox(once[i], 1e-12));
}

TEST(EvenCells, AreNoneEmptyWherePointsLieInAsManyPlaces) {
  Points points;  // a row of four, and one of six, on both sides of the border at 0.5
  for (int i = 0; i < 10; ++i)
    points.emplace_back(i < 4 ? 0.5 : 1.5, 0.9 + 0.02 * i, i == 3 ? 0.45 : 0.55);
  const Points means = means_of(points);
  ASSERT_EQ(means.size(), 2U);
  EXPECT_NEAR(std::min(means[0].x(), means[1].x()), 0.5, 1e-12);
  EXPECT_NEAR(std::max(means[0].x(), means[1].x()), 1.5, 1e-12);
}

TEST(EvenCells, OfAWallBelowAnEdgeKeepTheirPoints) {
  Points points;
  add_layer(4, 0.55, points);
  for (int y = 0; y < 4; ++y)
    points.emplace_back(1.95, 0.25 + 0.5 * y, 0.4);
  const Points means = means_of(points);
  ASSERT_EQ(means.size(), 2U);
  EXPECT_TRUE(lists(means, {1.95, 1, 0.4}));
}

TEST(EvenCells, OfTheEndOfASurfaceThatFillsTheNextCellKeepTheirPoints) {
  Points points;
  add_layer(8, 0.25, points);
  for (int y = 0; y < 8; ++y)
    points.emplace_back(2.1, 0.125 + 0.25 * y, 0.25);
  const Points means = means_of(points);
  ASSERT_EQ(means.size(), 2U);
  EXPECT_TRUE(lists(means, {2.1, 1, 0.25}));
}

}  // namespace
}  // namespace scan_cell_common
