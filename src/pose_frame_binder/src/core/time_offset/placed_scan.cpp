// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "time_offset/placed_scan.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace pose_frame_binder {

using scan_cell_common::from_seconds;
using scan_cell_common::to_seconds;

namespace {

std::optional<Eigen::Isometry3d> pose_at(const std::vector<TimedPose>& poses, Nanoseconds time,
                                         double max_gap) {
  const auto before = [](const TimedPose& pose, Nanoseconds t) { return pose.time < t; };
  const auto after = std::lower_bound(poses.begin(), poses.end(), time, before);
  if (after == poses.begin() || after == poses.end()) return std::nullopt;
  if (to_seconds(after->time - (after - 1)->time) > max_gap) return std::nullopt;
  return scan_cell_common::interpolate(*(after - 1), *after, time);
}

}  // namespace

PlacedScan::PlacedScan(const UnboundScan& scan, double delay, std::size_t most,
                       const TimeOffsetSettings& settings)
    : max_distance_(settings.max_distance) {
  constexpr double kAround = 0.02;  // [s] before and after, for the velocity; chosen
  std::size_t all = 0;
  for (const UnboundScan::Line& line : scan.lines)
    all += line.points.size();
  const std::size_t stride = all / std::max<std::size_t>(most, 1) + 1;
  std::size_t number = 0;
  for (const UnboundScan::Line& line : scan.lines) {
    const Nanoseconds time = line.time + from_seconds(delay);
    const Nanoseconds around = from_seconds(kAround);
    const auto before = pose_at(scan.poses, time - around, settings.max_pose_gap);
    const auto pose = pose_at(scan.poses, time, settings.max_pose_gap);
    const auto after = pose_at(scan.poses, time + around, settings.max_pose_gap);
    if (!before || !pose || !after) continue;
    for (const Eigen::Vector3d& point : line.points) {
      if (number++ % stride != 0 || !point.allFinite()) continue;
      points_.push_back({*pose * point, (*after * point - *before * point) / (2 * kAround)});
    }
  }
  if (!points_.empty()) tree_.emplace(points_);
}

Eigen::Vector3d PlacedScan::mean_velocity() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Point& point : points_)
    sum += point.velocity;
  return points_.empty() ? sum : Eigen::Vector3d(sum / static_cast<double>(points_.size()));
}

double PlacedScan::distance(const Eigen::Vector3d& place) const {
  Tree::Index nearest = 0;
  double square = 0;
  tree_->nearest(place.data(), 1, &nearest, &square);
  return std::sqrt(square);
}

std::optional<PlacedScan::Patch> PlacedScan::patch_at(const Eigen::Vector3d& place) const {
  constexpr std::size_t kPoints = 12;  // chosen
  constexpr double kIndependent = 3;   // of them: points of a line share its pose's error; chosen
  constexpr double kFlat = 0.1;        // thickness over width of a plane; chosen
  constexpr double kInside = 1.0;      // distance from the centre over width; chosen
  std::array<Tree::Index, kPoints> indices;
  std::array<double, kPoints> squares;
  if (tree_->nearest(place.data(), kPoints, indices.data(), squares.data()) < kPoints ||
      squares[0] > max_distance_ * max_distance_) {
    return std::nullopt;
  }
  Patch patch;
  patch.middle = patch.velocity = Eigen::Vector3d::Zero();
  for (const std::size_t i : indices) {
    patch.middle += points_[i].place / kPoints;
    patch.velocity += points_[i].velocity / kPoints;
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const std::size_t i : indices) {
    const Eigen::Vector3d off = points_[i].place - patch.middle;
    spread += off * off.transpose() / kPoints;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  patch.normal = axes.eigenvectors().col(0);
  const Eigen::Vector3d width = axes.eigenvalues().cwiseMax(0).cwiseSqrt();
  if (width[0] > kFlat * width[1]) return std::nullopt;
  patch.normal_noise = Eigen::Matrix3d::Zero();
  for (const Eigen::Index axis : {1, 2}) {
    const Eigen::Vector3d tilted = axes.eigenvectors().col(axis);
    patch.normal_noise +=
        std::pow(width[0] / width[axis], 2) / kIndependent * tilted * tilted.transpose();
  }
  const Eigen::Vector3d off = place - patch.middle;
  const double along = (off - patch.normal * patch.normal.dot(off)).norm();
  if (along > kInside * width[2]) return std::nullopt;
  return patch;
}

}  // namespace pose_frame_binder
