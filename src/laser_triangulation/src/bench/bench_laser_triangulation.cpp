// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Points a second on one core, compared with the plain way with cv::undistortPoints in the same
// run.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <opencv2/calib3d.hpp>
#include <utility>

#include "laser_triangulation/triangulator.h"
#include "scan_cell_common/tools/tool_main.h"

using namespace laser_triangulation;  // NOLINT

namespace {

constexpr std::size_t kRows = 1710;  // [px] of the LUPA3000

scan_cell_common::ScannerModel scanner() {
  scan_cell_common::ScannerModel model;
  model.camera.width = 1696;
  model.camera.height = 1710;
  model.camera.fx = 801.3;
  model.camera.fy = 800.6;
  model.camera.cx = 851.2;
  model.camera.cy = 852.7;
  model.camera.distortion << -0.081, 0.052, 0.0006, -0.0004, 0.0;
  model.flange_to_camera.translation() << 0.004, -0.003, 0.085;
  scan_cell_common::LaserPlane laser;
  laser.origin << -0.25, 0, 0.012;
  laser.normal = Eigen::Vector3d(0.89, -0.001, -0.456).normalized();
  laser.distance = laser.normal.dot(laser.origin);
  model.lasers.push_back(laser);
  return model;
}

constexpr std::size_t kProfiles = 100;  // chosen

/// Lines that bend and jump as on a moulding, and move across the sensor from profile to profile.
std::vector<std::vector<float>> lines() {
  std::vector<std::vector<float>> positions(kProfiles, std::vector<float>(kRows));
  for (std::size_t profile = 0; profile < kProfiles; ++profile) {
    const double place = 600 + 4 * static_cast<double>(profile);
    for (std::size_t row = 0; row < kRows; ++row) {
      const double step = row % 400 < 200 ? 40 : 0;
      positions[profile][row] =
          static_cast<float>(place + step + 30 * std::sin(static_cast<double>(row) / 90));
    }
  }
  return positions;
}

const cv::TermCriteria kOpenCvsOwn(cv::TermCriteria::COUNT, 5, 0.01);
const cv::TermCriteria kTightest(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 1000, 1e-15);

/// Computes a profile's rays with OpenCV.
void undistort(const scan_cell_common::CameraIntrinsics& camera, const std::vector<float>& position,
               const cv::TermCriteria& end, std::vector<cv::Point2d>& rays) {
  const cv::Matx33d matrix(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const std::vector<double> distortion(camera.distortion.begin(), camera.distortion.end());
  std::vector<cv::Point2d> pixels;
  for (std::size_t row = 0; row < position.size(); ++row)
    pixels.emplace_back(position[row], static_cast<double>(row));
  cv::undistortPoints(pixels, rays, matrix, distortion, cv::noArray(), cv::noArray(), end);
}

void plain_way(const scan_cell_common::ScannerModel& model, const std::vector<float>& position,
               const Eigen::Isometry3d& flange, const cv::TermCriteria& end,
               std::vector<Eigen::Vector3f>& points) {
  std::vector<cv::Point2d> rays;
  undistort(model.camera, position, end, rays);
  const Eigen::Isometry3d to_frame = flange * model.flange_to_camera;
  for (const cv::Point2d& ray : rays) {
    const Eigen::Vector3d direction(ray.x, ray.y, 1);
    const double depth = model.laser(0).distance / model.laser(0).normal.dot(direction);
    points.emplace_back((to_frame * (depth * direction)).cast<float>());
  }
}

/// Million points per second in the fastest pass over all profiles.
class Rate {
 public:
  explicit Rate(std::function<void(std::size_t)> profile) : profile_(std::move(profile)) {}

  void pass() {
    constexpr double kMillion = 1e6;
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < kProfiles; ++i)
      profile_(i);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    best_ = std::max(best_, static_cast<double>(kProfiles * kRows) / taken.count() / kMillion);
  }
  double best() const { return best_; }

 private:
  std::function<void(std::size_t)> profile_;
  double best_ = 0;
};

/// [m] greatest distance between points of the same rows; none if their numbers differ.
std::optional<double> farthest(const std::vector<ScanPoint>& points,
                               const std::vector<Eigen::Vector3f>& others) {
  if (points.size() != others.size()) return std::nullopt;
  double apart = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector3f point(points[k].x, points[k].y, points[k].z);
    apart = std::max(apart, static_cast<double>((point - others[k]).norm()));
  }
  return apart;
}

void pass_in_turns(const std::vector<Rate*>& rates) {
  constexpr int kPasses = 100;  // taken in turns, so that other load affects all alike; chosen
  for (int i = 0; i < kPasses; ++i) {
    for (Rate* rate : rates)
      rate->pass();
  }
}

int bench() {
  cv::setNumThreads(1);
  const scan_cell_common::ScannerModel model = scanner();
  const std::vector<std::vector<float>> position = lines();
  const std::vector<float> width(kRows, 5);
  const std::vector<float> intensity(kRows, 100);
  const Eigen::Isometry3d flange(Eigen::Translation3d(0.4, -0.2, 0.9));

  Triangulator triangulator(model, {});
  std::vector<ScanPoint> points;
  std::vector<Eigen::Vector3f> plain_points;
  const auto triangulate = [&](std::size_t i) {
    points.clear();
    triangulator.add({0, 0, kRows, position[i].data(), width.data(), intensity.data()}, flange,
                     points);
  };
  const auto triangulate_plainly = [&](std::size_t i, const cv::TermCriteria& end) {
    plain_points.clear();
    plain_way(model, position[i], flange, end, plain_points);
  };
  std::vector<cv::Point2d> rays;
  Rate ours(triangulate);
  Rate plain([&](std::size_t i) { triangulate_plainly(i, kOpenCvsOwn); });
  Rate undistorted([&](std::size_t i) { undistort(model.camera, position[i], kOpenCvsOwn, rays); });
  pass_in_turns({&ours, &plain, &undistorted});
  double apart = 0;
  for (std::size_t i = 0; i < kProfiles; ++i) {
    triangulate(i);
    triangulate_plainly(i, kTightest);
    const std::optional<double> most = farthest(points, plain_points);
    if (!most) return 1;
    apart = std::max(apart, *most);
  }
  constexpr double kMicrometre = 1e6;  // in a metre
  std::printf(
      "triangulation, one core: %.1f million points/s (goal 20); the plain way with "
      "cv::undistortPoints: %.1f, ratio %.1f (goal 10); cv::undistortPoints alone: %.1f; largest "
      "difference from it, iterated to its end: %.2f um\n",
      ours.best(), plain.best(), ours.best() / plain.best(), undistorted.best(),
      apart * kMicrometre);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Points a second of triangulation, beside the plain way with OpenCV");
  return scan_cell_common::tool_main("bench_laser_triangulation", app, argc, argv, bench);
}
