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

#include "cloud_file.h"
#include "laser_triangulation/triangulator.h"
#include "scan_cell_common/errors/errors.h"

using namespace laser_triangulation;  // NOLINT

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// The camera and lasers of the simulated cell.
scan_cell_common::ScannerModel scanner() {
  scan_cell_common::ScannerModel model;
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
    scan_cell_common::LaserPlane laser;
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

/// The image of the laser's line on the plane z = depth (camera frame) in a row, found by bisection
/// of the projection along the line, without undistortion.
std::optional<std::pair<double, Eigen::Vector3d>> see(const scan_cell_common::ScannerModel& model,
                                                      std::size_t laser, double depth, double row) {
  const scan_cell_common::LaserPlane& plane = model.laser(laser);
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
  const scan_cell_common::CameraIntrinsics camera = scanner().camera;
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
  scan_cell_common::CameraIntrinsics camera = scanner().camera;
  camera.distortion << -0.5, 0, 0, 0, 0;  // r (1 - r^2 / 2) never exceeds 0.545
  Eigen::Vector2d ray(0.7, 0);
  EXPECT_FALSE(camera.undistort({0.7, 0}, ray));
}

namespace {

struct LongRay {
  long double x, y;
};

/// The reference: Newton's method on OpenCV's lens model in 80-bit numbers, with the derivatives by
/// central differences. Shares nothing with the code under test.
LongRay reference_ray(const scan_cell_common::CameraIntrinsics& camera, double u, double v) {
  const auto distort = [&camera](LongRay ray) {
    const long double k1 = camera.distortion[0], k2 = camera.distortion[1],
                      p1 = camera.distortion[2], p2 = camera.distortion[3],
                      k3 = camera.distortion[4];
    const long double r2 = ray.x * ray.x + ray.y * ray.y;
    const long double radial = 1 + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2;
    return LongRay{ray.x * radial + 2 * p1 * ray.x * ray.y + p2 * (r2 + 2 * ray.x * ray.x),
                   ray.y * radial + p1 * (r2 + 2 * ray.y * ray.y) + 2 * p2 * ray.x * ray.y};
  };
  const LongRay goal{(static_cast<long double>(u) - camera.cx) / camera.fx,
                     (static_cast<long double>(v) - camera.cy) / camera.fy};
  LongRay ray = goal;
  constexpr long double kStep = 1e-7L;
  for (int i = 0; i < 50; ++i) {
    const LongRay here = distort(ray);
    const LongRay right = distort({ray.x + kStep, ray.y}), left = distort({ray.x - kStep, ray.y});
    const LongRay down = distort({ray.x, ray.y + kStep}), up = distort({ray.x, ray.y - kStep});
    const long double xx = (right.x - left.x) / (2 * kStep), yx = (right.y - left.y) / (2 * kStep);
    const long double xy = (down.x - up.x) / (2 * kStep), yy = (down.y - up.y) / (2 * kStep);
    const long double off_x = goal.x - here.x, off_y = goal.y - here.y;
    const long double determinant = xx * yy - xy * yx;
    ray.x += (yy * off_x - xy * off_y) / determinant;
    ray.y += (xx * off_y - yx * off_x) / determinant;
  }
  return ray;
}

}  // namespace

TEST(RayTable, IsExactOverTheWholeSensor) {
  for (const double k1 : {-0.081, -0.25, 0.2}) {
    scan_cell_common::CameraIntrinsics camera = scanner().camera;
    camera.distortion[0] = k1;
    const RayTable table(camera);
    double worst = 0;
    for (int row = 0; row < camera.height; row += 41) {
      for (float column = -0.5F; column <= static_cast<float>(camera.width) - 0.5F;
           column += 3.7F) {
        Eigen::Vector2d ray;
        table.find(static_cast<std::size_t>(row), &column, 1, &ray);
        const LongRay truth = reference_ray(camera, static_cast<double>(column), row);
        worst = std::max(worst, std::hypot(ray.x() - static_cast<double>(truth.x),
                                           ray.y() - static_cast<double>(truth.y)));
        ASSERT_EQ(worst, worst);
      }
    }
    EXPECT_LT(worst, 2e-9) << k1;
  }
}

TEST(RayTable, SaysNothingOfPixelsThatTheLensModelDoesNotReach) {
  scan_cell_common::CameraIntrinsics camera = scanner().camera;
  camera.distortion << -0.5, 0, 0, 0, 0;  // folds over at 0.545 from the middle, 436 px
  const RayTable table(camera);
  const auto ray = [&table](float column) {
    Eigen::Vector2d found;
    table.find(853, &column, 1, &found);
    return found;
  };
  EXPECT_TRUE(ray(852).allFinite());
  EXPECT_TRUE(ray(1200).allFinite());
  EXPECT_FALSE(ray(1300).allFinite());
  EXPECT_FALSE(ray(1600).allFinite());
  EXPECT_NEAR(ray(1200).x(), static_cast<double>(reference_ray(camera, 1200, 853).x), 2e-9);
}

TEST(RayTable, RefusesALensModelThatCannotBeUndoneAnywhere) {
  scan_cell_common::CameraIntrinsics camera = scanner().camera;
  camera.width = camera.height = 64;  // the sensor's corner only
  camera.distortion << -0.5, 0, 0, 0, 0;
  EXPECT_THROW(RayTable{camera}, scan_cell_common::UnusableInput);
}

TEST(Triangulator, IsExactToAMicrometreOverTheWholeImage) {
  const scan_cell_common::ScannerModel model = scanner();
  const Eigen::Isometry3d flange =
      Eigen::Translation3d(0.4, -0.2, 0.9) *
      Eigen::AngleAxisd(2.8, Eigen::Vector3d(1, 0.1, 0.2).normalized());
  const Eigen::Matrix4d to_frame = (flange * model.flange_to_camera).matrix();
  PeakLimits limits;
  limits.max_range = 3;
  Triangulator triangulator(model, limits);
  double worst = 0;
  std::size_t compared = 0;
  for (std::size_t laser = 0; laser < 2; ++laser) {
    for (float column = -0.5F; column < 1695.5F; column += 13.3F) {
      Profile profile(1710);
      for (std::size_t row = 0; row < 1710; row += 19)
        profile.position[row] = column + 0.01F * static_cast<float>(row % 100);
      std::vector<ScanPoint> points;
      triangulator.add(profile.view(laser), flange, points);
      std::size_t next = 0;
      for (std::size_t row = 0; row < 1710 && next < points.size(); row += 19) {
        const LongRay ray = reference_ray(model.camera, static_cast<double>(profile.position[row]),
                                          static_cast<double>(row));
        const scan_cell_common::LaserPlane& plane = model.laser(laser);
        const long double depth = plane.distance / (plane.normal.x() * ray.x +
                                                    plane.normal.y() * ray.y + plane.normal.z());
        if (!(depth >= limits.min_range && depth <= limits.max_range)) continue;
        long double off[3];
        const float* const found[3] = {&points[next].x, &points[next].y, &points[next].z};
        for (int axis = 0; axis < 3; ++axis) {
          off[axis] = *found[axis] -
                      (to_frame(axis, 0) * ray.x * depth + to_frame(axis, 1) * ray.y * depth +
                       to_frame(axis, 2) * depth + to_frame(axis, 3));
        }
        worst = std::max(worst, static_cast<double>(std::sqrt(off[0] * off[0] + off[1] * off[1] +
                                                              off[2] * off[2])));
        ++next;
        ++compared;
      }
      EXPECT_EQ(next, points.size());
    }
  }
  EXPECT_GT(compared, 10000U);
  EXPECT_LT(worst, 1e-6);
  RecordProperty("worst_um", std::to_string(worst * 1e6));
}

TEST(Triangulator, FindsAPlaneAtAKnownDepthWithBothLasersToAMicrometre) {
  const scan_cell_common::ScannerModel model = scanner();
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
        // A float resolves 3e-5 px of a column, and 6e-8 m of a coordinate.
        EXPECT_LT((point - truth[i]).norm(), 1e-6) << "row " << i;
        EXPECT_EQ(points[i].laser, laser);
        EXPECT_EQ(points[i].intensity, 100);
        EXPECT_EQ(points[i].width, 5);
      }
    }
  }
}

TEST(Triangulator, CountsWhatItLeavesOutByItsReason) {
  const scan_cell_common::ScannerModel model = scanner();
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
  profile.width[9] = kNaN;  // with limits, an unknown value is outside them
  PeakLimits limits;
  limits.min_width = 2;
  limits.max_width = 20;
  limits.min_intensity = 20;
  limits.max_intensity = 250;
  limits.min_range = 0.35;
  limits.max_range = 0.70;
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

TEST(Triangulator, SaysWhereTheCameraSawEachPointFrom) {
  const auto model = scanner();
  Profile profile(3);
  std::fill(profile.position.begin(), profile.position.end(), 820.0F);
  Triangulator triangulator(model, {});
  std::vector<ScanPoint> points;
  const Eigen::Isometry3d flange = Eigen::Translation3d(0.7, -0.2, 0.9) *
                                   Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, 3).normalized());
  triangulator.add(profile.view(0, 800), flange, points);
  ASSERT_EQ(points.size(), 3U);
  const Eigen::Vector3d camera = flange * model.flange_to_camera.translation();
  for (const ScanPoint& point : points) {
    EXPECT_NEAR(point.vp_x, camera.x(), 1e-6);
    EXPECT_NEAR(point.vp_y, camera.y(), 1e-6);
    EXPECT_NEAR(point.vp_z, camera.z(), 1e-6);
  }
}

TEST(Triangulator, RefusesLimitsThatContradictEachOther) {
  PeakLimits limits;
  limits.min_width = 10;
  limits.max_width = 5;
  EXPECT_THROW(Triangulator(scanner(), limits), scan_cell_common::InvalidParameter);
}

TEST(Triangulator, LeavesOutRowsBelowTheSensorAndLasersThatItDoesNotHave) {
  Profile profile(20);
  std::fill(profile.position.begin(), profile.position.end(), 820.0F);
  Triangulator triangulator(scanner(), {});
  std::vector<ScanPoint> points;
  triangulator.add(profile.view(0, 1700), Eigen::Isometry3d::Identity(), points);
  EXPECT_EQ(points.size(), 10U);
  EXPECT_EQ(triangulator.counts().outside_sensor, 10U);
  triangulator.add(profile.view(0, 4'000'000'000U), Eigen::Isometry3d::Identity(), points);
  triangulator.add(profile.view(2), Eigen::Isometry3d::Identity(), points);
  EXPECT_EQ(points.size(), 10U);
  EXPECT_EQ(triangulator.counts().outside_sensor, 50U);
}

TEST(ScanCloud, HoldsAllPointsInTheirOrderAcrossItsBlocks) {
  ScanCloud cloud;
  std::vector<ScanPoint> points;
  std::size_t count = 0;
  for (std::size_t size : {0U, 1U, 65534U, 3U, 1710U, 200000U, 65536U}) {
    points.resize(size);
    for (ScanPoint& point : points)
      point.intensity = static_cast<float>(count++);
    cloud.append(points);
  }
  ASSERT_EQ(cloud.size(), count);
  for (const std::size_t first : {std::size_t{0}, std::size_t{65536}, count - 5, count}) {
    std::vector<ScanPoint> copy(count - first);
    cloud.copy(first, reinterpret_cast<std::uint8_t*>(copy.data()));
    for (std::size_t i = 0; i < copy.size(); ++i)
      ASSERT_EQ(copy[i].intensity, static_cast<float>(first + i));
  }
  EXPECT_EQ(cloud[65536].intensity, 65536);
}

TEST(ScanFile, HoldsEveryPointWithAllThatItCarries) {
  const std::string path = testing::TempDir() + "/scan_" + std::to_string(getpid()) + ".ply";
  ScanCloud cloud;
  cloud.append({{1, 2, 3, 100, 0, 0, {}, 7}, {4, 5, 6, 50, 1, 9, {}, 8, 0.1F, 0.2F, 0.3F}});
  constexpr std::size_t kPoint = 34;  // bytes
  save_ply(path, cloud);
  std::ifstream file(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  const std::size_t end = bytes.find("end_header\n") + 11;
  EXPECT_NE(bytes.find("element vertex 2\n"), std::string::npos);
  ASSERT_EQ(bytes.size(), end + 2 * kPoint);
  float second[4], width, vp_z;
  std::memcpy(second, &bytes[end + kPoint], sizeof(second));
  std::memcpy(&width, &bytes[end + kPoint + 18], sizeof(width));
  EXPECT_EQ(second[0], 4);
  EXPECT_EQ(second[3], 50);
  EXPECT_EQ(bytes[end + kPoint + 16], 1);
  EXPECT_EQ(bytes[end + kPoint + 17], 9);
  EXPECT_EQ(width, 8);
  std::memcpy(&vp_z, &bytes[end + kPoint + 30], sizeof(vp_z));
  EXPECT_EQ(vp_z, 0.3F);
  save_ply(path, cloud, 0.001);
  std::ifstream in_millimetres(path, std::ios::binary);
  const std::string scaled((std::istreambuf_iterator<char>(in_millimetres)), {});
  ASSERT_EQ(scaled.size(), bytes.size());
  std::memcpy(second, &scaled[end + kPoint], sizeof(second));
  EXPECT_FLOAT_EQ(second[1], 5000);
  EXPECT_EQ(second[3], 50);
  std::memcpy(&vp_z, &scaled[end + kPoint + 30], sizeof(vp_z));
  EXPECT_FLOAT_EQ(vp_z, 300) << "a place, too";
  std::filesystem::remove(path);
  EXPECT_THROW(check_ply_output("scan.xyz"), scan_cell_common::FileError);
  EXPECT_THROW(save_ply("/no/such/folder/scan.ply", {}), scan_cell_common::FileError);
  EXPECT_THROW(save_ply("scan.xyz", {}), scan_cell_common::FileError);
}
