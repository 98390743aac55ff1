// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "board/rendered_board.h"
#include "images/board_detection.h"

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace scan_calibration;

namespace {

scan_cell_common::CameraIntrinsics camera() {
  scan_cell_common::CameraIntrinsics result{640, 480, 421, 420, 322.5, 236.2};
  result.distortion << -0.08, 0.05, 0.0006, -0.0004, 0;
  return result;
}

const BoardRenderer& renderer() {
  static const BoardRenderer result(camera(), 6);
  return result;
}

RenderedScene scene_of(const Board& board) {
  RenderedScene scene;
  scene.board = board;
  return scene;
}

std::vector<Isometry3d> poses(const Board& board) {
  std::vector<Isometry3d> result;
  for (int i = 0; i < 5; ++i) {
    result.push_back(board_pose(board, {0.02 * (i - 2), 0.01 * (i - 1), 0.3 + 0.04 * i},
                                0.15 + 0.1 * i, 1.1 * i, 0.3 * i - 0.5));
  }
  return result;
}

/// RMS distance of the corners from the true ones [px], along an axis; `count` of them are finite.
double rms_error(const BoardCorners& corners, const Isometry3d& pose, const Board& board,
                 int* count = nullptr) {
  double sum = 0;
  int finite = 0;
  for (int i = 0; i < static_cast<int>(corners.size()); ++i) {
    if (!corners[i].allFinite()) continue;
    const Vector2d truth = true_corner(camera(), pose, board, i % board.columns, i / board.columns);
    sum += (corners[i] - truth).squaredNorm() / 2;
    ++finite;
  }
  if (count != nullptr) *count = finite;
  return std::sqrt(sum / std::max(1, finite));
}

}  // namespace

TEST(BoardDetection, FindsCornersToAFiftiethOfAPixelWhereOpenCvsRefinementIsTwiceAsFarOff) {
  const Board board{9, 6, 0.02};
  double ours = 0, opencvs = 0;
  for (const Isometry3d& pose : poses(board)) {
    const cv::Mat image = renderer().render(scene_of(board), pose, 3);
    const BoardCorners corners = find_board(image, board);
    ASSERT_EQ(corners.size(), 54U);
    ours += std::pow(rms_error(corners, pose, board), 2) / 5;
    std::vector<cv::Point2f> moved;
    for (const Vector2d& corner : corners)
      moved.emplace_back(corner.x(), corner.y());
    cv::cornerSubPix(image, moved, {5, 5}, {-1, -1}, cv::TermCriteria(3, 50, 1e-4));
    BoardCorners by_opencv;
    for (const cv::Point2f& corner : moved)
      by_opencv.emplace_back(corner.x, corner.y);
    opencvs += std::pow(rms_error(by_opencv, pose, board), 2) / 5;
  }
  EXPECT_LT(std::sqrt(ours), 0.02);
  EXPECT_LT(std::sqrt(ours), 0.5 * std::sqrt(opencvs));
}

TEST(BoardDetection, StandsBlurAndNoise) {
  const Board board{9, 6, 0.02};
  RenderedScene scene = scene_of(board);
  scene.blur = 2.5;
  scene.noise = 5;
  for (const Isometry3d& pose : poses(board)) {
    const BoardCorners corners = find_board(renderer().render(scene, pose, 3), board);
    ASSERT_EQ(corners.size(), 54U);
    EXPECT_LT(rms_error(corners, pose, board), 0.1);
  }
}

TEST(BoardDetection, FindsADarkBoardBesideASaturatedLine) {
  const Board board{7, 6, 0.02};
  RenderedScene scene = scene_of(board);
  scene.white = 26;
  scene.black = 6;
  scene.table = 10;
  scene.noise = 1;
  scene.plate_margin = 0.15;
  scene.laser_light = 2000;
  scene.line_sigma = 1.5e-3;
  scene.laser.normal = Vector3d::UnitX();
  scene.laser.distance = 0.1;
  const Isometry3d pose = board_pose(board, {-0.02, 0, 0.3}, 0.2, 1, 0.2);
  const BoardCorners corners = find_board(renderer().render(scene, pose, 3), board);
  ASSERT_EQ(corners.size(), 42U);
  EXPECT_LT(rms_error(corners, pose, board), 0.08);
}

TEST(BoardDetection, TakesSixteenBitImages) {
  const Board board{9, 6, 0.02};
  const Isometry3d pose = poses(board)[1];
  cv::Mat image;
  renderer().render(scene_of(board), pose, 3).convertTo(image, CV_16U, 16);
  EXPECT_LT(rms_error(find_board(image, board), pose, board), 0.02);
}

TEST(BoardDetection, CountsFromTheSameCornerHoweverTheBoardIsTurned) {
  const Board board{9, 6, 0.02};  // its colours tell its ends apart
  for (int i = 0; i < 8; ++i) {
    const Isometry3d pose = board_pose(board, {0, 0, 0.4}, 0.2, 0.5, i * M_PI / 4);
    const BoardCorners corners =
        find_board(renderer().render(scene_of(board), pose, static_cast<std::uint32_t>(i)), board);
    ASSERT_EQ(corners.size(), 54U);
    EXPECT_LT(rms_error(corners, pose, board), 0.05) << "turned by " << i << " eighths";
  }
}

TEST(BoardDetection, LeavesOutCornersThatAreCoveredAndKeepsTheOthersInPlace) {
  const Board board{9, 6, 0.02};
  const Isometry3d pose = poses(board)[0];
  cv::Mat image = renderer().render(scene_of(board), pose, 3);
  const Vector2d covered = true_corner(camera(), pose, board, 0, 0);
  cv::circle(image, cv::Point(static_cast<int>(covered.x()) + 4, static_cast<int>(covered.y())), 7,
             cv::Scalar(255), cv::FILLED);
  const BoardCorners corners = find_board(image, board);
  if (corners.empty()) GTEST_SKIP() << "the detector does not find a board with such a cover";
  int count = 0;
  EXPECT_LT(rms_error(corners, pose, board, &count), 0.03);
  EXPECT_EQ(count, 53);
  EXPECT_FALSE(corners[0].allFinite());
}

TEST(BoardDetection, SeesNoBoardWhereThereIsNone) {
  cv::Mat noise(240, 320, CV_8UC1);
  cv::RNG engine(1);
  engine.fill(noise, cv::RNG::NORMAL, 90, 30);
  EXPECT_TRUE(find_board(noise, {9, 6, 0.02}).empty());
  EXPECT_TRUE(find_board(cv::Mat(240, 320, CV_8UC1, cv::Scalar(0)), {9, 6, 0.02}).empty());
}

TEST(BoardDetection, TellsTheSizeOfAnotherBoard) {
  const Board board{8, 5, 0.02};
  const cv::Mat image = renderer().render(scene_of(board), poses(board)[0], 3);
  EXPECT_EQ(size_of_any_board(image), std::pair(8, 5));
}
