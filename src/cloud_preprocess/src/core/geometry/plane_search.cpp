// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/plane_search.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>

#include "geometry/kd_tree.h"

namespace cloud_preprocess {
namespace {

constexpr std::size_t kSamplePoints = 20000;  // keeps the search well below a second; chosen
constexpr double kNormalNoise = 0.35;         // [rad] of a normal from few points; chosen

/// Least-squares plane; the normal is on the axis' side.
Plane fit_plane(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& axis) {
  Plane plane;
  plane.point = points.rowwise().mean();
  const Eigen::Matrix3Xd centred = points.colwise() - plane.point;
  const Eigen::Matrix3d covariance = centred * centred.transpose();
  plane.normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0);
  if (plane.normal.dot(axis) < 0) plane.normal = -plane.normal;
  return plane;
}

bool leans_too_far(const Eigen::Vector3d& normal, const PlaneSearch& search) {
  return search.tilt < M_PI / 2 && std::abs(normal.dot(search.axis)) < std::cos(search.tilt);
}

/// Tries planes through three points.
class Ransac {
 public:
  Ransac(const OrientedPoints& points, const PlaneSearch& search)
      : points_(points), search_(search) {}

  std::optional<Plane> run() {
    constexpr std::size_t kMaxDraws = 50000;  // of three points; chosen
    constexpr std::size_t kMaxCounts = 3000;  // of a plane's inliers; chosen
    std::size_t counts = 0;
    for (std::size_t draws = 1; draws <= needed_ && draws <= kMaxDraws; ++draws) {
      const std::optional<Plane> plane = draw();
      if (!plane) continue;
      count(*plane);
      if (++counts == kMaxCounts) break;
    }
    return best_;
  }

 private:
  /// A plane through three random points; none if they, or their normals, do not fit together.
  std::optional<Plane> draw() {
    std::array<Eigen::Index, 3> chosen{};
    for (Eigen::Index& index : chosen)
      index = static_cast<Eigen::Index>(generator_() % points_.size());
    const Eigen::Vector3d a = points_.points.col(chosen[0]);
    const Eigen::Vector3d ab = points_.points.col(chosen[1]) - a;
    const Eigen::Vector3d ac = points_.points.col(chosen[2]) - a;
    const Eigen::Vector3d cross = ab.cross(ac);
    constexpr double kThinnest = 1e-2;  // sine of the angle between two sides; chosen
    if (!(cross.norm() > kThinnest * ab.norm() * ac.norm())) return std::nullopt;
    const Plane plane{a, cross.normalized()};
    if (leans_too_far(plane.normal, search_)) return std::nullopt;
    for (const Eigen::Index index : chosen) {
      if (std::abs(plane.normal.dot(points_.normals.col(index))) < std::cos(kNormalNoise))
        return std::nullopt;
    }
    return plane;
  }

  /// Counts the inliers. The more there are, the fewer draws are needed to find a plane as good.
  void count(const Plane& plane) {
    constexpr double kMiss = 1e-4;  // probability of missing the best plane; chosen
    const auto heights =
        (plane.normal.transpose() * points_.points).array() - plane.normal.dot(plane.point);
    const Eigen::Index found = (heights.abs() <= search_.distance).count();
    if (found <= max_) return;
    max_ = found;
    best_ = plane;
    const double share = static_cast<double>(found) / static_cast<double>(points_.size());
    const double hit = std::pow(share, 3);
    needed_ = hit < 1 ? static_cast<std::size_t>(std::log(kMiss) / std::log1p(-hit)) : 0;
  }

  const OrientedPoints& points_;
  const PlaneSearch& search_;
  std::mt19937 generator_{1};
  Eigen::Index max_ = 0;
  std::size_t needed_ = static_cast<std::size_t>(-1);
  std::optional<Plane> best_;
};

std::vector<Eigen::Index> inliers_of(const Plane& plane, const OrientedPoints& points,
                                     double distance) {
  std::vector<Eigen::Index> inliers;
  for (Eigen::Index i = 0; i < points.points.cols(); ++i) {
    if (std::abs(plane.height(Eigen::Vector3d(points.points.col(i)))) <= distance &&
        std::abs(plane.normal.dot(points.normals.col(i))) >= std::cos(kNormalNoise))
      inliers.push_back(i);
  }
  return inliers;
}

}  // namespace

OrientedPoints OrientedPoints::only(const std::vector<Eigen::Index>& indices) const {
  OrientedPoints chosen;
  chosen.points = points(Eigen::all, indices);
  chosen.normals = normals(Eigen::all, indices);
  chosen.spacing = spacing;
  return chosen;
}

OrientedPoints sample_with_normals(const Cloud& cloud) {
  Cloud chosen;
  std::mt19937 generator(1);
  std::sample(cloud.begin(), cloud.end(), std::back_inserter(chosen), kSamplePoints, generator);
  constexpr std::size_t kNeighbours = 10;  // includes the point itself; chosen
  const KdTree tree(chosen);
  std::vector<KdTree::Index> indices(std::min(kNeighbours, chosen.size()));
  std::vector<float> squared(indices.size());
  std::vector<double> nearest;
  OrientedPoints result;
  result.points.resize(3, static_cast<Eigen::Index>(chosen.size()));
  result.normals.resize(3, static_cast<Eigen::Index>(chosen.size()));
  Eigen::Matrix3Xd around(3, static_cast<Eigen::Index>(indices.size()));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    tree.nearest(chosen[i].data, indices.size(), indices.data(), squared.data());
    for (std::size_t k = 0; k < indices.size(); ++k) {
      around.col(static_cast<Eigen::Index>(k)) = chosen[indices[k]].getVector3fMap().cast<double>();
    }
    const auto column = static_cast<Eigen::Index>(i);
    result.points.col(column) = chosen[i].getVector3fMap().cast<double>();
    result.normals.col(column) = fit_plane(around, Eigen::Vector3d::UnitZ()).normal;
    nearest.push_back(squared.size() > 1 ? std::sqrt(static_cast<double>(squared[1])) : 0);
  }
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  if (!nearest.empty()) result.spacing = *middle;
  return result;
}

std::optional<FoundPlane> largest_plane(const OrientedPoints& points, const PlaneSearch& search) {
  constexpr std::size_t kLeast = 3;  // points of a plane
  if (points.size() < kLeast) return std::nullopt;
  const std::optional<Plane> best = Ransac(points, search).run();
  if (!best) return std::nullopt;
  FoundPlane found{*best, inliers_of(*best, points, search.distance)};
  constexpr int kRefits = 3;  // chosen
  for (int i = 0; i < kRefits && found.inliers.size() >= kLeast; ++i) {
    found.plane = fit_plane(points.points(Eigen::all, found.inliers), search.axis);
    found.inliers = inliers_of(found.plane, points, search.distance);
  }
  if (found.inliers.size() < kLeast || leans_too_far(found.plane.normal, search))
    return std::nullopt;
  return found;
}

}  // namespace cloud_preprocess
