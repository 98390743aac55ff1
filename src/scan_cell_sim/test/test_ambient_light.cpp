// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "config_folder.h"
#include "scan_cell_sim/laser_line_renderer.h"
#include "test_worlds.h"

namespace scan_cell_sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Region kSensor = {0, 0, 1696, 1710};
constexpr double kLong = 0.03;    // [s] shows the room
constexpr double kShort = 0.001;  // [s] of a scan

scan_cell_common::ScannerModel scanner() {
  return scan_cell_common::load_scanner_model(kConfig + "/scanner.yaml");
}

Optics noiseless_in_room_light() {
  Optics optics;
  optics.background = optics.read_noise = optics.shot_noise = 0;
  return optics;
}

/// A world with a board on the ground around its origin, with z downwards.
World with_board() {
  World world;
  world.board = Checkerboard{};
  world.board->pose.linear() = Eigen::AngleAxisd(M_PI, Vector3d::UnitX()).toRotationMatrix();
  world.board->pose.translation() << -0.14, 0.24, 0;
  return world;
}

/// A camera that looks at the board from the side, slightly turned.
Exposure from_above(double duration) {
  Exposure exposure;
  exposure.duration = duration;
  exposure.camera.translation() << 0.12, -0.1, 0.45;
  exposure.camera.linear() = (Eigen::AngleAxisd(0.2, Vector3d::UnitZ()) *
                              Eigen::AngleAxisd(M_PI - 0.2, Vector3d::UnitX()) *
                              Eigen::AngleAxisd(-0.25, Vector3d::UnitY()))
                                 .toRotationMatrix();
  return exposure;
}

class BoardImage {
 public:
  BoardImage(const World& world, const Exposure& exposure, const Optics& optics,
             const Region& region = kSensor)
      : region_(region), pixels_(static_cast<std::size_t>(region.width * region.height)) {
    const LaserLineRenderer renderer(scanner(), optics);
    renderer.render(Scene(world), exposure, region, pixels_.data());
  }

  double at(double x, double y) const {
    const int column = static_cast<int>(std::lround(x)) - region_.x;
    const int row = static_cast<int>(std::lround(y)) - region_.y;
    return pixels_[static_cast<std::size_t>(row * region_.width + column)];
  }

  /// The place to which the directions of all gradients around it are perpendicular: a corner of a
  /// checkerboard (Foerstner and Guelch 1987).
  Vector2d corner_near(Vector2d place) const {
    constexpr int kReach = 6;
    for (int step = 0; step < 10; ++step) {
      Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
      Vector2d moment = Vector2d::Zero();
      for (double y = std::round(place.y()) - kReach; y <= place.y() + kReach; ++y) {
        for (double x = std::round(place.x()) - kReach; x <= place.x() + kReach; ++x) {
          const Vector2d pixel(x, y);
          const double weight = std::exp(-(pixel - place).squaredNorm() / 8);
          const Vector2d gradient(at(x + 1, y) - at(x - 1, y), at(x, y + 1) - at(x, y - 1));
          const Eigen::Matrix2d outer = weight * gradient * gradient.transpose();
          sum += outer;
          moment += outer * pixel;
        }
      }
      place = sum.inverse() * moment;
    }
    return place;
  }

  const std::vector<std::uint8_t>& pixels() const { return pixels_; }

 private:
  Region region_;
  std::vector<std::uint8_t> pixels_;
};

bool well_inside(const Vector2d& pixel) {
  constexpr double kEdge = 12;
  return pixel.minCoeff() > kEdge && pixel.x() < kSensor.width - kEdge &&
         pixel.y() < kSensor.height - kEdge;
}

TEST(AmbientLight, ShowsTheBoardsCornersWhereTheLensPutsThem) {
  const World world = with_board();
  const Exposure exposure = from_above(kLong);
  const BoardImage image(world, exposure, noiseless_in_room_light());
  const Checkerboard& board = *world.board;
  double sum = 0, worst = 0;
  int seen = 0;
  for (int row = 0; row < board.rows; ++row) {
    for (int column = 0; column < board.columns; ++column) {
      const Vector3d corner(column * board.square_size, row * board.square_size, 0);
      const Vector2d pixel =
          scanner().camera.project(exposure.camera.inverse() * (board.pose * corner));
      if (!well_inside(pixel)) continue;
      const double error = (image.corner_near(pixel) - pixel).norm();
      sum += error * error;
      worst = std::max(worst, error);
      ++seen;
    }
  }
  ASSERT_GT(seen, 250);
  EXPECT_LT(std::sqrt(sum / seen), 0.02);  // [px] what 256 grey values allow
  EXPECT_LT(worst, 0.06);
}

TEST(AmbientLight, TheSquareBeforeTheFirstCornerIsBlack) {
  const World world = with_board();
  Exposure exposure = from_above(kLong);
  exposure.camera.translation() += world.board->pose.translation();
  const Optics optics = noiseless_in_room_light();
  const BoardImage image(world, exposure, optics);
  const auto grey = [&](double x, double y) {
    const Vector3d point = world.board->pose * Vector3d(x, y, 0);
    const Vector2d pixel = scanner().camera.project(exposure.camera.inverse() * point);
    return image.at(pixel.x(), pixel.y());
  };
  const double level = optics.ambient * kLong / optics.exposure;
  EXPECT_NEAR(grey(-0.01, -0.01), level * world.board->black, 1);
  EXPECT_NEAR(grey(0.01, -0.01), level * world.board->white, 1);
  EXPECT_NEAR(grey(0.01, 0.01), level * world.board->black, 1);
  EXPECT_NEAR(grey(-0.03, -0.03), level * world.board->white, 1) << "the plate around the squares";
  EXPECT_NEAR(grey(-0.02, 0.01), level * world.board->white, 1) << "where a white square meets it";
}

TEST(AmbientLight, AShortExposureShowsNothingOfTheRoom) {
  Optics dark = noiseless_in_room_light();
  dark.ambient = 0;
  const Region region = {336, 599, 1024, 512};
  Exposure exposure = from_above(kShort);
  exposure.lasers = 1;
  const BoardImage lit(with_board(), exposure, noiseless_in_room_light(), region);
  EXPECT_EQ(lit.pixels(), BoardImage(with_board(), exposure, dark, region).pixels());
  exposure.duration = kLong;
  EXPECT_NE(BoardImage(with_board(), exposure, noiseless_in_room_light(), region).pixels(),
            BoardImage(with_board(), exposure, dark, region).pixels());
}

TEST(AmbientLight, WhatStandsBeforeTheBoardHidesIt) {
  World world = with_board();
  world.parts.push_back(box("box", {0.06, 0.06, 0.05}, pose(0, 0, 0, 0.3)));
  world.parts[0].reflectance = 0.5;
  const Exposure exposure = from_above(kLong);
  const Optics optics = noiseless_in_room_light();
  const BoardImage image(world, exposure, optics);
  for (const double x : {-0.015, 0.0, 0.015}) {
    const Vector2d pixel =
        scanner().camera.project(exposure.camera.inverse() * Vector3d(x, 0, 0.05));
    EXPECT_NEAR(image.at(pixel.x(), pixel.y()), optics.ambient * kLong / optics.exposure * 0.5, 1);
  }
}

TEST(AmbientLight, ALaserLineIsDarkerOnBlackSquares) {
  const World world = with_board();
  const Checkerboard& board = *world.board;
  const Scene scene(world);
  const Vector3d down = -Vector3d::UnitZ();
  for (const double x : {-0.01, 0.01}) {
    const Vector3d above = board.pose * Vector3d(x, 0.01, 0) - 0.3 * down;
    const auto hit = scene.first_hit(above, down);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->reflectance, x < 0 ? board.white : board.black, 1e-9);
  }
}

}  // namespace
}  // namespace scan_cell_sim
