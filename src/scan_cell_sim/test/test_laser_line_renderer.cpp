// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "config_folder.h"
#include "scan_cell_sim/laser_line_renderer.h"
#include "test_worlds.h"

namespace scan_cell_sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using scan_cell_common::ScannerModel;

const Region kRegion = {336, 599, 1024, 512};

Optics noiseless() {
  Optics optics;
  optics.background = optics.ambient = optics.read_noise = optics.shot_noise = 0;
  return optics;
}

World floor_only(double height = 0) {
  World world;
  world.floor = Floor{};
  world.floor->height = height;
  return world;
}

/// Camera at a height over the floor, looking down, its x along the world's x, slightly tilted.
Eigen::Isometry3d looking_down(double height, const Vector3d& tilt = Vector3d::Zero()) {
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
  camera.translation() << 0, 0, height;
  camera.linear() = Eigen::AngleAxisd(M_PI, Vector3d::UnitX()).toRotationMatrix();
  if (tilt.norm() > 0) camera.rotate(Eigen::AngleAxisd(tilt.norm(), tilt.normalized()));
  return camera;
}

class Image {
 public:
  Image(const LaserLineRenderer& renderer, const World& world, const Exposure& exposure,
        const Region& region = kRegion)
      : region_(region), pixels_(static_cast<std::size_t>(region.width * region.height)) {
    renderer.render(Scene(world), exposure, region, pixels_.data());
  }

  int at(int sensor_row, int sensor_column) const {
    return pixels_[static_cast<std::size_t>((sensor_row - region_.y) * region_.width +
                                            sensor_column - region_.x)];
  }

  /// Centre of gravity of a sensor row between two sensor columns; nothing where it is dark.
  std::optional<double> centre(int row, int begin, int end) const {
    double sum = 0, moment = 0;
    for (int column = begin; column < end; ++column) {
      sum += at(row, column);
      moment += static_cast<double>(at(row, column)) * column;
    }
    if (sum < 100) return std::nullopt;
    return moment / sum;
  }
  std::optional<double> centre(int row) const {
    return centre(row, region_.x, region_.x + region_.width);
  }

  const std::vector<std::uint8_t>& pixels() const { return pixels_; }

 private:
  Region region_;
  std::vector<std::uint8_t> pixels_;
};

/// Projection by the textbook's formula (Brown 1966), independent of the scanner model's.
Vector2d textbook_projection(const ScannerModel& scanner, const Vector3d& p) {
  const auto& c = scanner.camera;
  const double x = p.x() / p.z(), y = p.y() / p.z();
  const double r2 = x * x + y * y, r4 = r2 * r2, r6 = r4 * r2;
  const double k1 = c.distortion[0], k2 = c.distortion[1], p1 = c.distortion[2],
               p2 = c.distortion[3], k3 = c.distortion[4];
  const double radial = 1 + k1 * r2 + k2 * r4 + k3 * r6;
  return {c.fx * (x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)) + c.cx,
          c.fy * (y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y) + c.cy};
}

/// Sensor column at which a laser on the plane z = height (in world) crosses a sensor row: the
/// laser plane and that plane meet in a line, whose projection is followed by bisection.
double line_column(const ScannerModel& scanner, std::size_t laser, const Eigen::Isometry3d& camera,
                   double height, int row) {
  const Vector3d n1 = scanner.laser(laser).normal;
  const Vector3d n2 = camera.linear().transpose() * Vector3d::UnitZ();
  const double d1 = scanner.laser(laser).distance;
  const double d2 = height - camera.translation().z();
  const Vector3d way = n1.cross(n2);
  const Vector3d on_both =
      (d1 * n2.cross(way) + d2 * way.cross(n1)) / way.squaredNorm();  // Goldman 1990
  const Vector3d along = way / way.y();                               // by the camera's y
  double least = -1, most = 1;
  for (int i = 0; i < 100; ++i) {
    const double middle = (least + most) / 2;
    const Vector3d point = on_both + along * (middle - on_both.y());
    (textbook_projection(scanner, point).y() < row ? least : most) = middle;
  }
  return textbook_projection(scanner, on_both + along * (least - on_both.y())).x();
}

/// No lens distortion, laser planes that meet the camera's axis 0.5 m in front.
ScannerModel plain_scanner() {
  ScannerModel scanner;
  scanner.camera.width = 1696;
  scanner.camera.height = 1710;
  scanner.camera.fx = scanner.camera.fy = 800;
  scanner.camera.cx = 848;
  scanner.camera.cy = 855;
  for (const double side : {-1.0, 1.0}) {
    scan_cell_common::LaserPlane laser;
    laser.origin = {0.25 * side, 0, 0};
    laser.normal = Vector3d(-0.5 * side, 0, -0.25).normalized();
    laser.distance = laser.normal.dot(laser.origin);
    scanner.lasers.push_back(laser);
  }
  return scanner;
}

void expect_analytic_line(double height, std::size_t laser, const Vector3d& tilt) {
  const ScannerModel scanner = scan_cell_common::load_scanner_model(kConfig + "/scanner.yaml");
  Exposure exposure;
  exposure.camera = looking_down(0.5, tilt);
  exposure.lasers = static_cast<std::uint8_t>(1U << laser);
  exposure.duration = 0.0016;  // a bright line: rounding to grey values matters less
  const Image image(LaserLineRenderer(scanner, noiseless()), floor_only(height), exposure);
  double worst = 0;
  for (int row = kRegion.y; row < kRegion.y + kRegion.height; ++row) {
    const auto centre = image.centre(row);
    ASSERT_TRUE(centre) << row;
    worst = std::max(worst,
                     std::abs(*centre - line_column(scanner, laser, exposure.camera, height, row)));
  }
  EXPECT_LT(worst, 0.02) << "height " << height << " laser " << laser;
}

TEST(LaserLine, IsCentredOnTheAnalyticProjectionInEveryRow) {
  for (const double height : {0.0, 0.04, 0.1, -0.05}) {
    for (const std::size_t laser : {0U, 1U}) {
      expect_analytic_line(height, laser, Vector3d::Zero());
      expect_analytic_line(height, laser, Vector3d(0.03, -0.05, 0.1));
    }
  }
}

TEST(LaserLine, FollowsTheBoxsTopAndTheFloorBesideIt) {
  const ScannerModel scanner = plain_scanner();
  World world = floor_only();
  world.parts.push_back(box("box", {0.06, 0.05, 0.04}, pose(0, 0, 0)));
  Exposure exposure;
  exposure.camera = looking_down(0.5);
  exposure.lasers = 1;
  const Image image(LaserLineRenderer(scanner, noiseless()), world, exposure);
  for (int row = kRegion.y; row < kRegion.y + kRegion.height; ++row) {
    const double top_y = (row - 855) / 800.0 * 0.46;
    const double floor_y = (row - 855) / 800.0 * 0.5;
    const bool on_top = std::abs(top_y) < 0.024;
    const bool on_floor = std::abs(floor_y) > 0.026 * 0.5 / 0.46;
    if (!on_top && !on_floor) continue;
    const auto centre = image.centre(row);
    ASSERT_TRUE(centre) << row;
    // The plane meets the height z below the camera at x = -0.25 + z / 2.
    const double z = on_top ? 0.46 : 0.5;
    EXPECT_NEAR(*centre, 848 + 800 * (-0.25 + z / 2) / z, 0.02) << row;
  }
}

/// A plate 0.2 m over the floor around a place, 0.06 m square.
World plate_at(double x) {
  World world = floor_only();
  world.parts.push_back(box("plate", {0.06, 0.06, 0.002}, pose(x, 0, 0.2)));
  return world;
}

/// Whether the floor's line can be seen at the sensor's middle column in a row.
bool floor_line(const Image& image, int row) {
  return image.centre(row, 848 - 12, 848 + 13).has_value();
}

TEST(LaserLine, IsHiddenWhereSomethingStandsBeforeTheLaser) {
  // The plane is 0.25 - 0.3 / 2 = 0.1 m left of the camera at the plate's height.
  Exposure exposure;
  exposure.camera = looking_down(0.5);
  exposure.lasers = 1;
  const Image image(LaserLineRenderer(plain_scanner(), noiseless()), plate_at(-0.1), exposure);
  EXPECT_FALSE(floor_line(image, 855));
  EXPECT_TRUE(floor_line(image, 855 + 150));
  EXPECT_TRUE(image.centre(855, kRegion.x, 700));  // the plate itself is lit

  // The other laser comes from the right, past the plate.
  exposure.lasers = 2;
  const Image other(LaserLineRenderer(plain_scanner(), noiseless()), plate_at(-0.1), exposure);
  EXPECT_TRUE(floor_line(other, 855));
}

TEST(LaserLine, IsHiddenWhereSomethingStandsBeforeTheCamera) {
  Exposure exposure;
  exposure.camera = looking_down(0.5);
  exposure.lasers = 1;
  const Image image(LaserLineRenderer(plain_scanner(), noiseless()), plate_at(0), exposure);
  EXPECT_FALSE(floor_line(image, 855));
  EXPECT_TRUE(floor_line(image, 855 + 150));
}

TEST(LaserLine, ShadowEndsWhereGeometrySaysIt) {
  Exposure exposure;
  exposure.camera = looking_down(0.5);
  exposure.lasers = 1;
  const Image image(LaserLineRenderer(plain_scanner(), noiseless()), plate_at(0), exposure);
  // The plate's lower edge at y = +-0.03, 0.3 m below the camera, hides rows up to 855 + 80.
  EXPECT_FALSE(floor_line(image, 855 + 79));
  EXPECT_TRUE(floor_line(image, 855 + 81));
  EXPECT_FALSE(floor_line(image, 855 - 79));
  EXPECT_TRUE(floor_line(image, 855 - 81));
}

TEST(LaserLine, IsAsBrightAsItsShareOfTheExposure) {
  Exposure exposure;
  exposure.camera = looking_down(0.4);
  exposure.lasers = 3;
  exposure.duration = 0.0004;  // not saturated
  const LaserLineRenderer renderer(plain_scanner(), noiseless());
  const Image whole(renderer, floor_only(), exposure);
  exposure.light = {0.25, 0.75};
  const Image shared(renderer, floor_only(), exposure);
  int brightest = 0;
  for (int column = kRegion.x; column < kRegion.x + kRegion.width; ++column) {
    const double share = column < 848 ? 0.25 : 0.75;  // laser_0's line is left of laser_1's
    EXPECT_NEAR(shared.at(855, column), share * whole.at(855, column), 1.5) << column;
    brightest = std::max(brightest, whole.at(855, column));
  }
  EXPECT_GT(brightest, 50);
  EXPECT_LT(brightest, 255);
  exposure.light = {0, 1};
  const Image alone(renderer, floor_only(), exposure);
  exposure.lasers = 2;
  exposure.light = {1, 1};
  EXPECT_EQ(alone.pixels(), Image(renderer, floor_only(), exposure).pixels());
}

TEST(LaserLine, BothLasersShowOffTheCrossing) {
  Exposure exposure;
  exposure.camera = looking_down(0.4);
  exposure.lasers = 3;
  const Image image(LaserLineRenderer(plain_scanner(), noiseless()), floor_only(), exposure);
  // x = -+(0.25 - 0.4 / 2) at z = 0.4
  EXPECT_NEAR(*image.centre(855, 600, 848), 848 - 800 * 0.05 / 0.4, 0.02);
  EXPECT_NEAR(*image.centre(855, 848, 1100), 848 + 800 * 0.05 / 0.4, 0.02);
  exposure.lasers = 0;
  const Image dark(LaserLineRenderer(plain_scanner(), noiseless()), floor_only(), exposure);
  EXPECT_FALSE(dark.centre(855));
}

TEST(LaserLine, FadesWithIncidenceAndReflectance) {
  Exposure exposure;
  exposure.camera = looking_down(0.5);
  exposure.lasers = 1;
  const Optics optics = noiseless();
  World world = floor_only();
  world.floor->reflectance = 0.5;
  const Image image(LaserLineRenderer(plain_scanner(), optics), world, exposure);
  // At normal incidence at 0.5 m the peak would be `brightness`; here the ray is sqrt(0.3125) m
  // long, at cos = 0.5 / that length.
  const double way = std::sqrt(0.25 * 0.25 + 0.5 * 0.5);
  EXPECT_NEAR(image.at(855, 848), optics.brightness * 0.5 * (0.5 / way) * (0.5 / way), 1);
}

TEST(LaserLine, SaturatesWithoutWrapping) {
  Exposure exposure;
  exposure.camera = looking_down(0.5);
  exposure.lasers = 1;
  exposure.duration = 0.02;
  const Image image(LaserLineRenderer(plain_scanner(), noiseless()), floor_only(), exposure);
  int saturated = 0;
  for (int column = 848 - 3; column <= 848 + 3; ++column)
    saturated += image.at(855, column) == 255;
  EXPECT_GE(saturated, 7);
  EXPECT_NEAR(*image.centre(855), 848, 0.02);
}

TEST(LaserLine, RegionIsAWindowOnTheSameSensor) {
  const LaserLineRenderer renderer(plain_scanner(), noiseless());
  Exposure exposure;
  exposure.camera = looking_down(0.5);
  exposure.lasers = 1;
  const Image whole(renderer, floor_only(), exposure, {0, 0, 1696, 1710});
  const Image part(renderer, floor_only(), exposure, kRegion);
  for (int row = kRegion.y; row < kRegion.y + kRegion.height; ++row) {
    EXPECT_NEAR(*part.centre(row), *whole.centre(row), 0.01);
  }
}

TEST(Noise, IsTheSameForTheSameFrameAndAnotherForTheNext) {
  const LaserLineRenderer renderer(plain_scanner(), Optics{});
  Exposure exposure;
  exposure.camera = looking_down(0.5);
  exposure.lasers = 1;
  exposure.frame = 7;
  const Image first(renderer, floor_only(), exposure);
  const Image again(LaserLineRenderer(plain_scanner(), Optics{}), floor_only(), exposure);
  EXPECT_EQ(first.pixels(), again.pixels());
  exposure.frame = 8;
  const Image next(renderer, floor_only(), exposure);
  EXPECT_NE(first.pixels(), next.pixels());
}

TEST(Noise, HasTheStatedSpread) {
  Optics optics;
  optics.background = 20;
  optics.read_noise = 3;
  Exposure exposure;
  exposure.camera = looking_down(0.5);
  const Image image(LaserLineRenderer(plain_scanner(), optics), floor_only(), exposure);
  double sum = 0, squares = 0;
  for (const std::uint8_t pixel : image.pixels()) {
    sum += pixel;
    squares += pixel * pixel;
  }
  const double count = static_cast<double>(image.pixels().size());
  const double mean = sum / count;
  EXPECT_NEAR(mean, 20, 0.05);
  EXPECT_NEAR(std::sqrt(squares / count - mean * mean), std::sqrt(9 + 1 / 12.0), 0.05);
}

}  // namespace
}  // namespace scan_cell_sim
