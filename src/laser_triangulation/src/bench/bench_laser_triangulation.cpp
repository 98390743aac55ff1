// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Points a second on one core, beside the plain way with cv::undistortPoints in the same run.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <opencv2/calib3d.hpp>

#include "laser_triangulation/triangulator.h"

using namespace laser_triangulation;  // NOLINT

namespace {

constexpr std::size_t kRows = 1710;

ScannerModel scanner() {
  ScannerModel model;
  model.camera.width = 1696;
  model.camera.height = 1710;
  model.camera.fx = 801.3;
  model.camera.fy = 800.6;
  model.camera.cx = 851.2;
  model.camera.cy = 852.7;
  model.camera.distortion << -0.081, 0.052, 0.0006, -0.0004, 0.0;
  model.flange_to_camera.translation() << 0.004, -0.003, 0.085;
  LaserPlane laser;
  laser.origin << -0.25, 0, 0.012;
  laser.normal = Eigen::Vector3d(0.89, -0.001, -0.456).normalized();
  laser.distance = laser.normal.dot(laser.origin);
  model.lasers.push_back(laser);
  return model;
}

/// A line that bends and jumps as on a moulding.
std::vector<float> line() {
  std::vector<float> position(kRows);
  for (std::size_t row = 0; row < kRows; ++row) {
    const double step = row % 400 < 200 ? 40 : 0;
    position[row] = static_cast<float>(800 + step + 30 * std::sin(static_cast<double>(row) / 90));
  }
  return position;
}

/// Each peak through OpenCV, a profile at a time, with OpenCV's own termination.
void plain_way(const ScannerModel& model, const std::vector<float>& position,
               const Eigen::Isometry3d& flange, std::vector<Eigen::Vector3f>& points) {
  const CameraIntrinsics& camera = model.camera;
  const cv::Matx33d matrix(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const std::vector<double> distortion(camera.distortion.begin(), camera.distortion.end());
  std::vector<cv::Point2d> pixels;
  for (std::size_t row = 0; row < position.size(); ++row)
    pixels.emplace_back(position[row], static_cast<double>(row));
  std::vector<cv::Point2d> rays;
  cv::undistortPoints(pixels, rays, matrix, distortion);
  const Eigen::Isometry3d to_frame = flange * model.flange_to_camera;
  for (const cv::Point2d& ray : rays) {
    const Eigen::Vector3d direction(ray.x, ray.y, 1);
    const double depth = model.lasers[0].distance / model.lasers[0].normal.dot(direction);
    points.emplace_back((to_frame * (depth * direction)).cast<float>());
  }
}

/// Points a second of the fastest of some repetitions.
double rate(const std::function<void()>& profile) {
  constexpr int kRepetitions = 20;
  constexpr int kProfiles = 100;
  double best = 0;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < kProfiles; ++i)
      profile();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    best = std::max(best, kProfiles * static_cast<double>(kRows) / taken.count());
  }
  return best;
}

}  // namespace

int main() {
  cv::setNumThreads(1);
  const ScannerModel model = scanner();
  const std::vector<float> position = line();
  const std::vector<float> width(kRows, 5);
  const std::vector<float> intensity(kRows, 100);
  const Eigen::Isometry3d flange(Eigen::Translation3d(0.4, -0.2, 0.9));

  Triangulator triangulator(model, {});
  std::vector<ScanPoint> points;
  const double ours = rate([&] {
    points.clear();
    triangulator.add({0, 0, kRows, position.data(), width.data(), intensity.data()}, flange,
                     points);
  });
  std::vector<Eigen::Vector3f> plain_points;
  const double plain = rate([&] {
    plain_points.clear();
    plain_way(model, position, flange, plain_points);
  });
  double apart = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f point(points[i].x, points[i].y, points[i].z);
    apart = std::max(apart, static_cast<double>((point - plain_points[i]).norm()));
  }
  constexpr double kMillion = 1e6;
  constexpr double kMicrometre = 1e6;
  std::printf(
      "triangulation, one core: %.1f million points/s; cv::undistortPoints, plain: %.1f million "
      "points/s; ratio %.1f; largest difference %.2f um\n",
      ours / kMillion, plain / kMillion, ours / plain, apart * kMicrometre);
  return 0;
}
