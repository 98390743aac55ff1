// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <opencv2/calib3d.hpp>
#include <optional>

#include "laser_triangulation/cloud_file.h"
#include "laser_triangulation/triangulator.h"
#include "scan_cell_common/errors.h"

using namespace laser_triangulation;  // NOLINT

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// The camera and lasers of the simulated cell.
ScannerModel scanner() {
  ScannerModel model;
  model.camera.width = 1696;
  model.camera.height = 1710;
  model.camera.fx = 801.3;
  model.camera.fy = 800.6;
  model.camera.cx = 851.2;
  model.camera.cy = 852.7;
  model.camera.distortion << -0.081, 0.052, 0.0006, -0.0004, 0.0;
  model.flange_to_camera = Eigen::Translation3d(0.004, -0.003, 0.085) *
                           Eigen::AngleAxisd(0.021, Eigen::Vector3d(0.6, -0.4, 0.7).normalized());
  for (const double side : {-1.0, 1.0}) {
    LaserPlane laser;
    laser.origin << 0.25 * side, 0, 0.012;
    laser.normal = Eigen::Vector3d(-0.89 * side, -0.001, -0.456).normalized();
    laser.distance = laser.normal.dot(laser.origin);
    model.lasers.push_back(laser);
  }
  return model;
}

struct Profile {
  explicit Profile(std::size_t rows) : position(rows, kNaN), width(rows, 5), intensity(rows, 100) {}
  ProfileView view(std::size_t laser, std::uint32_t first_row = 0) const {
    return {laser, first_row, position.size(), position.data(), width.data(), intensity.data()};
  }
  std::vector<float> position, width, intensity;
};

/// Where the laser's line on the plane z = depth (camera frame) is seen in a row, found by
/// bisection of the projection along the line: no undistortion is used.
std::optional<std::pair<double, Eigen::Vector3d>> see(const ScannerModel& model, std::size_t laser,
                                                      double depth, double row) {
  const LaserPlane& plane = model.lasers[laser];
  const auto on_line = [&](double y) {
    const double x =
        (plane.distance - plane.normal.y() * y - plane.normal.z() * depth) / plane.normal.x();
    return Eigen::Vector3d(x, y, depth);
  };
  double low = -0.6, high = 0.6;
  if (model.camera.project(on_line(low)).y() > row) return std::nullopt;
  if (model.camera.project(on_line(high)).y() < row) return std::nullopt;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (model.camera.project(on_line(middle)).y() < row ? low : high) = middle;
  }
  const Eigen::Vector3d point = on_line((low + high) / 2);
  return std::make_pair(model.camera.project(point).x(), point);
}

}  // namespace

TEST(Undistort, AgreesWithOpenCvAndTheProjectionOverTheWholeSensor) {
  const CameraIntrinsics camera = scanner().camera;
  const cv::Matx33d matrix(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const std::vector<double> distortion(camera.distortion.begin(), camera.distortion.end());
  const cv::TermCriteria exact(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 1000, 1e-15);
  for (int v = 0; v < camera.height; v += 57) {
    for (int u = 0; u < camera.width; u += 53) {
      std::vector<cv::Point2d> pixel = {{static_cast<double>(u), static_cast<double>(v)}};
      std::vector<cv::Point2d> expected;
      cv::undistortPoints(pixel, expected, matrix, distortion, cv::noArray(), cv::noArray(), exact);
      const Eigen::Vector2d distorted((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy);
      Eigen::Vector2d ray = distorted;
      ASSERT_TRUE(camera.undistort(distorted, ray));
      EXPECT_NEAR(ray.x(), expected[0].x, 1e-9);
      EXPECT_NEAR(ray.y(), expected[0].y, 1e-9);
      EXPECT_LT((camera.distort(ray) - distorted).norm(), 1e-14);
    }
  }
}

TEST(Undistort, SaysWhereTheLensModelFoldsOver) {
  CameraIntrinsics camera = scanner().camera;
  camera.distortion << -0.5, 0, 0, 0, 0;  // r (1 - r^2 / 2) never exceeds 0.545
  Eigen::Vector2d ray(0.7, 0);
  EXPECT_FALSE(camera.undistort({0.7, 0}, ray));
}

TEST(RayTable, IsExactBetweenItsNodesToo) {
  for (const double k1 : {-0.081, -0.25, 0.2}) {
    CameraIntrinsics camera = scanner().camera;
    camera.distortion[0] = k1;
    const RayTable table(camera);
    for (int row = 0; row < camera.height; row += 41) {
      for (double column = -0.5; column <= camera.width - 0.5; column += 3.7) {
        const Eigen::Vector2d ray = table.ray(static_cast<std::size_t>(row), column);
        const Eigen::Vector2d pixel = camera.project({ray.x(), ray.y(), 1});
        EXPECT_NEAR(pixel.x(), column, 2e-5);  // 12 nm at 0.5 m
        EXPECT_NEAR(pixel.y(), row, 2e-5);
      }
    }
  }
}

TEST(Triangulator, FindsAPlaneAtAKnownDepthWithBothLasersToAMicrometre) {
  const ScannerModel model = scanner();
  const Eigen::Isometry3d flange =
      Eigen::Translation3d(0.4, -0.2, 0.9) *
      Eigen::AngleAxisd(2.8, Eigen::Vector3d(1, 0.1, 0.2).normalized());
  for (std::size_t laser = 0; laser < 2; ++laser) {
    for (const double depth : {0.35, 0.5, 0.65}) {
      constexpr std::uint32_t kFirstRow = 300;
      Profile profile(1000);
      std::vector<Eigen::Vector3d> truth;
      std::vector<double> rounding;
      for (std::size_t row = 0; row < profile.position.size(); ++row) {
        const auto seen = see(model, laser, depth, kFirstRow + static_cast<double>(row));
        if (!seen) continue;
        profile.position[row] = static_cast<float>(seen->first);
        truth.push_back(flange * model.flange_to_camera * seen->second);
      }
      ASSERT_GT(truth.size(), 800U);
      Triangulator triangulator(model, {});
      std::vector<ScanPoint> points;
      triangulator.add(profile.view(laser, kFirstRow), flange, points);
      ASSERT_EQ(points.size(), truth.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d point(points[i].x, points[i].y, points[i].z);
        // A float column carries 3e-5 px, and a float coordinate 6e-8 m.
        EXPECT_LT((point - truth[i]).norm(), 1e-6) << "row " << i;
        EXPECT_EQ(points[i].laser, laser);
        EXPECT_EQ(points[i].intensity, 100);
      }
    }
  }
}

TEST(Triangulator, CountsWhatItLeavesOutByItsReason) {
  const ScannerModel model = scanner();
  Profile profile(12);
  for (std::size_t row = 0; row < 12; ++row)
    profile.position[row] = static_cast<float>(see(model, 0, 0.5, 800 + row)->first);
  profile.position[0] = kNaN;
  profile.position[1] = 5000;
  profile.position[2] = std::numeric_limits<float>::infinity();
  profile.width[3] = 1;
  profile.width[4] = 30;
  profile.intensity[5] = 10;
  profile.intensity[6] = 255;
  profile.position[7] = static_cast<float>(see(model, 0, 0.30, 807)->first);
  profile.position[8] = static_cast<float>(see(model, 0, 0.90, 808)->first);
  profile.width[9] = kNaN;  // with limits, what is not known is not within them
  PeakLimits limits;
  limits.least_width = 2;
  limits.most_width = 20;
  limits.least_intensity = 20;
  limits.most_intensity = 250;
  limits.least_range = 0.35;
  limits.most_range = 0.70;
  Triangulator triangulator(model, limits);
  std::vector<ScanPoint> points;
  triangulator.add(profile.view(0, 800), Eigen::Isometry3d::Identity(), points);
  const PeakCounts& counts = triangulator.counts();
  EXPECT_EQ(counts.rows_without_peak, 1U);
  EXPECT_EQ(counts.outside_sensor, 2U);
  EXPECT_EQ(counts.by_width, 3U);
  EXPECT_EQ(counts.by_intensity, 2U);
  EXPECT_EQ(counts.by_range, 2U);
  EXPECT_EQ(counts.points, 2U);
  EXPECT_EQ(points.size(), 2U);
  EXPECT_EQ(counts.points + counts.rejected() + counts.rows_without_peak, 12U);
}

TEST(Triangulator, RefusesLimitsThatContradictEachOther) {
  PeakLimits limits;
  limits.least_width = 10;
  limits.most_width = 5;
  EXPECT_THROW(Triangulator(scanner(), limits), scan_cell_common::InvalidParameter);
}

TEST(ScanFile, HoldsEveryPointWithIntensityAndLaser) {
  const std::string path = testing::TempDir() + "/scan_" + std::to_string(getpid()) + ".ply";
  save_ply(path, {{1, 2, 3, 100, 0, {}}, {4, 5, 6, 50, 1, {}}});
  std::ifstream file(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  const std::size_t end = bytes.find("end_header\n") + 11;
  EXPECT_NE(bytes.find("element vertex 2\n"), std::string::npos);
  ASSERT_EQ(bytes.size(), end + 2 * 17);
  float second[4];
  std::memcpy(second, &bytes[end + 17], sizeof(second));
  EXPECT_EQ(second[0], 4);
  EXPECT_EQ(second[3], 50);
  EXPECT_EQ(bytes.back(), 1);
  std::filesystem::remove(path);
  EXPECT_THROW(save_ply("/no/such/folder/scan.ply", {}), scan_cell_common::FileError);
  EXPECT_THROW(save_ply("scan.xyz", {}), scan_cell_common::FileError);
}
