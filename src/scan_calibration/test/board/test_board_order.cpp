// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "images/board_order.h"

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace scan_calibration;

namespace {

Matrix3d about_z(int quarters) {
  return AngleAxisd(quarters * M_PI / 2, Vector3d::UnitZ()).toRotationMatrix();
}

/// Corners in counting order: a flat grid.
BoardCorners grid(const Board& board) {
  BoardCorners corners;
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column)
      corners.emplace_back(column, row);
  return corners;
}

/// Views whose corners were counted from any of the board's ends.
std::vector<int> shuffle(std::vector<TurnableView>& views, const Board& board, int count) {
  std::mt19937 engine(7);
  std::normal_distribution<double> normal;
  const Matrix3d camera_in_flange =
      AngleAxisd(1.1, Vector3d(0.3, -0.5, 0.7).normalized()).toRotationMatrix();
  const std::vector<int> choices = symmetries(board);
  std::vector<int> turns;
  for (int i = 0; i < count; ++i) {
    const Matrix3d flange =
        AngleAxisd(0.6 * normal(engine),
                   Vector3d(normal(engine), normal(engine), normal(engine)).normalized())
            .toRotationMatrix();
    turns.push_back(i == 0 ? 0 : choices[engine() % choices.size()]);
    const Matrix3d noise = AngleAxisd(0.003 * normal(engine), Vector3d::UnitX()).toRotationMatrix();
    // Counted from an end that lies `turns` back, so they must be turned forward by this number.
    views.push_back(
        {flange, (flange * camera_in_flange).transpose() * noise * about_z(-turns.back())});
  }
  return turns;
}

}  // namespace

TEST(BoardOrder, TurnsCornersAndAxesTheSameWay) {
  const Board square{4, 4, 1};
  const BoardCorners corners = grid(square);
  for (int quarters = 0; quarters < 4; ++quarters) {
    const BoardCorners result = turned(corners, square, quarters);
    const Vector3d along = about_z(quarters) * Vector3d::UnitX();
    EXPECT_TRUE((result[1] - result[0]).isApprox(along.head<2>(), 1e-12)) << quarters;
    const Vector3d down = about_z(quarters) * Vector3d::UnitY();
    EXPECT_TRUE((result[4] - result[0]).isApprox(down.head<2>(), 1e-12)) << quarters;
  }
  EXPECT_EQ(turned(grid({3, 5, 1}), {3, 5, 1}, 2).front(), Vector2d(2, 4));
}

TEST(BoardOrder, KnowsWhichBoardsLookTheSameFromOtherEnds) {
  EXPECT_EQ(symmetries({7, 6, 1}), std::vector<int>{0});
  EXPECT_EQ(symmetries({15, 25, 1}), (std::vector<int>{0, 2}));
  EXPECT_EQ(symmetries({7, 7, 1}), (std::vector<int>{0, 2}));
  EXPECT_EQ(symmetries({8, 8, 1}), (std::vector<int>{0, 1, 2, 3}));
}

TEST(BoardOrder, IsFoundFromTheRobotsMotion) {
  for (const Board& board : {Board{15, 25, 1}, Board{8, 8, 1}}) {
    std::vector<TurnableView> views;
    const std::vector<int> turns = shuffle(views, board, 30);
    const std::vector<int> found = align_corners(views, board);
    // The whole set may be counted from another end, together with the first view.
    EXPECT_EQ(found, turns) << board.columns;
  }
}
