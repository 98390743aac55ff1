// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "laser_lines/board_line.h"
#include "session/rendered_session.h"

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace scan_calibration;

namespace {

class LineOnABoard : public testing::Test {
 protected:
  LineOnABoard() {
    scene_.board = session_.board;
    scene_.room_light = 0.05;
    scene_.laser_light = 600;
    scene_.laser = session_.truth.laser(0);
  }

  cv::Mat image() const {
    static const BoardRenderer renderer(session_.truth.camera, 4);
    return renderer.render(scene_, pose_, 5);
  }

  BoardLine read(const cv::Mat& seen) const {
    return board_line(line_peaks(seen, "fir_derivative"), session_.truth.camera, pose_,
                      session_.board, 300);
  }

  /// Distances of points on the board from the laser's plane [m].
  std::vector<double> off_plane(const BoardLine& line) const {
    const auto& camera = session_.truth.camera;
    std::vector<double> result;
    for (const Vector2d& pixel : line.pixels) {
      const Vector2d distorted((pixel.x() - camera.cx) / camera.fx,
                               (pixel.y() - camera.cy) / camera.fy);
      Vector2d ray = distorted;
      EXPECT_TRUE(camera.undistort(distorted, ray));
      const Vector3d direction(ray.x(), ray.y(), 1);
      const Vector3d normal = pose_.linear().col(2);
      const Vector3d point = direction * normal.dot(pose_.translation()) / normal.dot(direction);
      result.push_back(scene_.laser.normal.dot(point) - scene_.laser.distance);
    }
    return result;
  }

  double rms(const BoardLine& line) const {
    double sum = 0;
    for (const double off : off_plane(line))
      sum += off * off / static_cast<double>(line.pixels.size());
    return std::sqrt(sum);
  }

  double mean(const BoardLine& line) const {
    double sum = 0;
    for (const double off : off_plane(line))
      sum += off / static_cast<double>(line.pixels.size());
    return sum;
  }

  RenderedSession session_ = example_session(1);
  Isometry3d pose_ = board_pose(session_.board, {0.01, 0, 0.3}, 0.3, 0.4, 0.35);
  RenderedScene scene_;
};

}  // namespace

TEST_F(LineOnABoard, LiesOnTheLasersPlaneInSpiteOfTheSquares) {
  const BoardLine line = read(image());
  ASSERT_GT(line.pixels.size(), 80U) << line.reason;
  EXPECT_GT(line.counts.at_edges, 10);
  EXPECT_LT(rms(line), 5e-5);  // a pixel is 6e-4 m
  EXPECT_LT(std::abs(mean(line)), 2e-5);
}

TEST_F(LineOnABoard, IsNotTakenFromTheTableThoughMoreOfItIsThere) {
  pose_ = board_pose(session_.board, {0.03, 0, 0.42}, 0.2, 0.4, 0.1);
  scene_.plate_margin = 0.005;
  scene_.plate_height = 0.02;
  scene_.table = 200;
  const BoardLine line = read(image());
  ASSERT_GT(line.pixels.size(), 20U) << line.reason;
  EXPECT_LT(rms(line), 1e-4);
  EXPECT_GT(line.counts.off_line, static_cast<int>(line.pixels.size()));
}

TEST_F(LineOnABoard, IsTakenBesideTheCheckerWhereThePlateCarriesOn) {
  pose_ = board_pose(session_.board, {-0.09, 0, 0.33}, 0.15, 0.4, 0.1);
  scene_.plate_margin = 0.15;
  const BoardLine line = read(image());
  ASSERT_GT(line.pixels.size(), 200U) << line.reason;
  EXPECT_LT(rms(line), 5e-5);
}

TEST_F(LineOnABoard, IsFoundWhereItLiesAlongTheRows) {
  session_.truth.lasers[0]->normal = Vector3d(0.02, 0.9, -0.4).normalized();
  scene_.laser.normal = session_.truth.laser(0).normal;
  scene_.laser.distance = scene_.laser.normal.z() * 0.3;
  const BoardLine line = read(image());
  ASSERT_GT(line.pixels.size(), 80U) << line.reason;
  EXPECT_LT(rms(line), 5e-5);
}

TEST_F(LineOnABoard, IsFoundBesideABrighterReflection) {
  cv::Mat seen = image();
  cv::ellipse(seen, {600, 200}, {25, 120}, 10, 0, 360, cv::Scalar(255), 14);
  const BoardLine line = read(seen);
  ASSERT_GT(line.pixels.size(), 80U) << line.reason;
  EXPECT_LT(rms(line), 5e-5);
}

TEST_F(LineOnABoard, IsSaturatedAndWideAndStillExact) {
  scene_.laser_light = 3000;
  scene_.line_sigma = 2.5e-3;
  scene_.plate_margin = 0.1;
  pose_ = board_pose(session_.board, {-0.09, 0, 0.3}, 0.15, 0.4, 0.1);
  const BoardLine line = read(image());
  ASSERT_GT(line.pixels.size(), 100U) << line.reason;
  EXPECT_GT(line.width, 12);
  EXPECT_LT(rms(line), 1e-4);
}

TEST_F(LineOnABoard, IsNoneWhereTheLaserIsOffAndSaysSo) {
  scene_.laser_light = 0;
  scene_.room_light = 1;
  const BoardLine line = read(image());
  EXPECT_TRUE(line.pixels.empty()) << line.pixels.size();
  EXPECT_EQ(line.reason.find("no straight line on the board"), 0U) << line.reason;
  scene_.room_light = 0;
  EXPECT_TRUE(read(image()).pixels.empty());
}

TEST_F(LineOnABoard, CountsWhatBecameOfEveryPeak) {
  const BoardLine line = board_line(line_peaks(image(), "fir_derivative"), session_.truth.camera,
                                    pose_, session_.board, 50);
  const LineCounts& counts = line.counts;
  EXPECT_EQ(counts.used, 50);
  EXPECT_GT(counts.thinned, 0);
  EXPECT_EQ(counts.peaks, counts.off_line + counts.at_edges + counts.thinned + counts.used);
}
