// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scanner_views/blocks.h"
#include "scanner_views/scanner/line_scanner.h"

using namespace scanner_views;
using Eigen::Vector3d;

namespace {

Scanner without_noise() {
  Scanner scanner;
  scanner.peak_noise = scanner.speckle = 0;
  return scanner;
}

/// A scan from straight above, along x.
ScanPoints scan_from_above(const Mesh& mesh, const Scanner& scanner, bool both_lasers = false) {
  const scan_cell_sim::Scene scene({mesh}, 0.7);
  Sweep sweep;
  sweep.head = Eigen::AngleAxisd(M_PI, Vector3d::UnitX()).toRotationMatrix();
  sweep.second_laser = both_lasers;
  for (const Vector3d& vertex : mesh.vertices)
    sweep.extent.extend(sweep.head.transpose() * vertex);
  Draws draws(3);
  ScanPoints points;
  LineScanner(scene, scanner).scan(sweep, draws, points);
  return points;
}

}  // namespace

TEST(LineScanner, WithoutNoisePointsAwayFromEdgesLieOnThePart) {
  const ScanPoints points = scan_from_above(step(), without_noise(), true);
  ASSERT_GT(points.places.size(), 10000U);
  std::size_t on_top = 0;
  for (const Vector3d& at : points.places) {
    if (std::abs(at.x()) > 0.018 || std::abs(at.y()) > 0.028) continue;
    ++on_top;
    EXPECT_NEAR(at.z(), 0.04, 1e-5);
  }
  EXPECT_GT(on_top, 1000U);
}

TEST(LineScanner, AStepThrowsAShadowAsLongAsTheLightIsSlanted) {
  // One laser, half a metre below and a quarter beside the camera: behind a step of 30 mm, its
  // light meets the lower face after 15 mm. The camera looks straight down.
  const ScanPoints points = scan_from_above(step(), without_noise());
  double nearest = 1;  // [m] of the lower face behind the step
  double before = 1;   // and in front of it
  for (const Vector3d& at : points.places) {
    if (std::abs(at.y()) > 0.02 || at.z() > 0.012) continue;
    if (at.x() > 0.02) nearest = std::min(nearest, at.x() - 0.02);
    if (at.x() < -0.02) before = std::min(before, -0.02 - at.x());
  }
  EXPECT_NEAR(nearest, 0.030 * 0.25 / 0.5, 0.002);
  EXPECT_LT(before, 0.003);
}

TEST(LineScanner, ASecondLaserLightsTheShadow) {
  const ScanPoints points = scan_from_above(step(), without_noise(), true);
  double nearest = 1;
  for (const Vector3d& at : points.places) {
    if (std::abs(at.y()) < 0.02 && at.z() < 0.012 && at.x() > 0.02)
      nearest = std::min(nearest, at.x() - 0.02);
  }
  EXPECT_LT(nearest, 0.003);
}

TEST(LineScanner, PointsBetweenTwoFacesAreOnlyAtEdges) {
  const ScanPoints points = scan_from_above(step(), without_noise(), true);
  const Mesh mesh = step();
  const scan_cell_sim::Scene scene({mesh}, 1);
  std::size_t between = 0;
  for (const Vector3d& at : points.places) {
    if (scene.distance_to_surface(at) < 0.0003) continue;
    ++between;
    const double to_edge_x =
        std::min(std::abs(std::abs(at.x()) - 0.02), std::abs(0.05 - std::abs(at.x())));
    const double to_edge_y =
        std::min(std::abs(std::abs(at.y()) - 0.03), std::abs(0.05 - std::abs(at.y())));
    EXPECT_LT(std::min(to_edge_x, to_edge_y), 0.004) << at.transpose();
  }
  EXPECT_GT(between, 20U);
}

TEST(LineScanner, NoiseAlongTheLightGrowsAsItGrazes) {
  Scanner scanner;
  scanner.speckle = 0;
  const double slope = std::atan2(scanner.baseline, scanner.stand_off);
  // Planes that slope away from the light, which comes from smaller x.
  const auto rms_of = [&](double lean) {
    const Mesh level = block(0.1, 0.1, 0.005);
    const Eigen::AngleAxisd turn(lean, Vector3d::UnitY());
    const Mesh mesh = moved(level, [&](const Vector3d& at) -> Vector3d { return turn * at; });
    double sum = 0, count = 0;
    for (const Vector3d& at : scan_from_above(mesh, scanner).places) {
      const Vector3d on_part = turn.inverse() * at;
      if (on_part.head<2>().cwiseAbs().maxCoeff() > 0.03) continue;
      sum += std::pow((on_part.z() - 0.005) / std::cos(slope + lean), 2);
      count += 1;
    }
    return count < 100 ? 1.0 : std::sqrt(sum / count);
  };
  // 0.05 px of 800 px at 0.5 m, seen at the light's slope, divided by the root of the returned
  // light
  const double seen = 0.05 * 0.5 / 800 / std::sin(slope);
  EXPECT_NEAR(rms_of(0), seen / std::sqrt(std::cos(slope)), 0.1 * seen);
  EXPECT_NEAR(rms_of(0.7), seen / std::sqrt(std::cos(slope + 0.7)), 0.1 * seen);
  EXPECT_EQ(rms_of(0.9), 1.0) << "no peak at 78 degrees";
}

TEST(LineScanner, SpeckleLimitsTheDepthAsPublished) {
  // Dorsch, Hausler and Herrmann 1994: contrast x wavelength / (2 pi sin(aperture) sin(angle)), of
  // red light through a lens of 6.4 mm at f/4
  Scanner scanner;
  scanner.peak_noise = 0;
  const double aperture = 0.0064 / 4 / 2 / scanner.stand_off;
  const double angle = std::atan2(scanner.baseline, scanner.stand_off);
  const double published = scanner.speckle * 660e-9 / (2 * M_PI * aperture * std::sin(angle));
  double sum = 0, count = 0;
  for (const Vector3d& at : scan_from_above(block(0.1, 0.1, 0.005), scanner).places) {
    if (at.head<2>().cwiseAbs().maxCoeff() > 0.04) continue;
    sum += std::pow(at.z() - 0.005, 2);
    count += 1;
  }
  ASSERT_GT(count, 1000);
  EXPECT_NEAR(std::sqrt(sum / count), published, 0.3 * published);
}

TEST(LineScanner, PointsKnowTheCameraThatSawThem) {
  const ScanPoints points = scan_from_above(block(0.1, 0.1, 0.02), without_noise(), true);
  ASSERT_EQ(points.seen_from.size(), points.places.size());
  for (std::size_t i = 0; i < points.places.size(); ++i) {
    const Vector3d way = points.seen_from[i] - points.places[i];
    EXPECT_NEAR(way.z(), 0.5, 0.03);
    EXPECT_LT(std::abs(way.x()), 0.02) << "straight above: the line crosses the camera's axis";
  }
}
