// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/surface/smoothed_cloud.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "scan_cell_common/geometry/point_tree.h"

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;
using scan_cell_common::PointTree;
using Found = std::vector<std::pair<PointTree::Index, double>>;  // squared distances [m^2]
using Coefficients = Eigen::Matrix<double, 6, 1>;

constexpr double kReach = 3.5;       // spacings about a point: some 38 neighbours; chosen
constexpr double kSameFace = 0.82;   // cosine of normals: 35 degrees; chosen
constexpr std::size_t kFewest = 10;  // neighbours for six unknowns; chosen

/// 1, u, v, u^2, uv, v^2
Coefficients terms(double u, double v) {
  Coefficients result;
  result << 1, u, v, u * u, u * v, v * v;
  return result;
}

/// A neighbour of a point, in spacings.
struct Neighbour {
  Coefficients row;  // terms() of its place in the plane
  double height;     // over the plane
  double weight;
};

/// Whether the neighbours lie on one side of the point, where the slope of a fit is less certain.
bool is_one_sided(const std::vector<Neighbour>& neighbours) {
  constexpr double kAside = 0.2;  // of the reach, of their middle; chosen
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weights = 0;
  for (const Neighbour& each : neighbours) {
    sum += each.weight * each.row.segment<2>(1);
    weights += each.weight;
  }
  return sum.norm() > kAside * kReach * weights;
}

Coefficients weighted_fit(const std::vector<Neighbour>& neighbours,
                          const std::vector<double>& trust) {
  constexpr double kSteady = 1e-6;  // of points that lie on one line; chosen
  Eigen::Matrix<double, 6, 6> matrix = kSteady * Eigen::Matrix<double, 6, 6>::Identity();
  Coefficients right = Coefficients::Zero();
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    const Neighbour& each = neighbours[i];
    matrix += trust[i] * each.weight * each.row * each.row.transpose();
    right += trust[i] * each.weight * each.height * each.row;
  }
  return matrix.ldlt().solve(right);
}

/// Fit of second order, with Tukey's weights against stray points.
Coefficients fitted(const std::vector<Neighbour>& neighbours) {
  constexpr int kRounds = 5;        // chosen: more change nothing
  constexpr double kTukey = 4.685;  // deviations (Holland, Welsch 1977)
  constexpr double kMedian =
      1.4826;                        // deviation over median of the sizes, of a normal distribution
  constexpr double kFinest = 0.002;  // spacings; chosen
  std::vector<double> trust(neighbours.size(), 1);
  Coefficients heights = weighted_fit(neighbours, trust);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> off;
    for (const Neighbour& each : neighbours)
      off.push_back(std::abs(each.height - each.row.dot(heights)));
    std::vector<double> sorted = off;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double most = kTukey * std::max(kFinest, kMedian * *middle);
    for (std::size_t i = 0; i < off.size(); ++i)
      trust[i] = off[i] < most ? std::pow(1 - std::pow(off[i] / most, 2), 2) : 0;
    heights = weighted_fit(neighbours, trust);
  }
  return heights;
}

class Smoother {
 public:
  Smoother(const Points& points, Points normals, double spacing, const Vector3d& towards)
      : points_(points),
        normals_(std::move(normals)),
        spacing_(spacing),
        towards_(towards),
        search_(points) {}

  SmoothedCloud run() {
    sharpen();
    SmoothedCloud result;
    for (std::size_t i = 0; i < points_.size(); ++i)
      fit(i, result);
    return result;
  }

 private:
  Found around(std::size_t i, double reach) const {
    Found found;
    search_.within(points_[i].data(), std::pow(reach * spacing_, 2), found);
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Number of the points around a point that lie in the plane through it.
  std::size_t votes(const Vector3d& at, const Vector3d& normal, const Found& found) const {
    constexpr double kInPlane = 0.25;  // spacings; chosen
    return static_cast<std::size_t>(
        std::count_if(found.begin(), found.end(), [&](const auto& each) {
          return std::abs(normal.dot(points_[each.first] - at)) < kInPlane * spacing_;
        }));
  }

  /// Near an edge, the normal of the plane through all neighbours belongs to neither face.
  void sharpen() {
    Points sharp = normals_;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Found found = around(i, kReach);
      const bool smooth = std::all_of(found.begin(), found.end(), [&](const auto& each) {
        return normals_[each.first].dot(normals_[i]) > kSameFace;
      });
      if (!smooth) sharp[i] = best_normal(i, found);
    }
    normals_ = sharp;
    for (std::size_t i = 0; i < points_.size(); ++i)
      at_edge_.push_back(is_at_edge(i));
  }

  /// Beside a sharp edge a cell of the grid reaches over it: its point is the mean of both faces
  /// and lies on neither.
  bool is_at_edge(std::size_t i) const {
    constexpr double kBeside = 1.5;  // spacings; chosen
    const Found found = around(i, kBeside);
    return std::any_of(found.begin(), found.end(), [&](const auto& each) {
      return normals_[each.first].dot(normals_[i]) < kSameFace;
    });
  }

  Vector3d best_normal(std::size_t i, const Found& found) const {
    constexpr double kTie = 0.85;  // of the votes: what faces the viewer more wins; chosen
    std::size_t most = 0;
    for (const auto& each : found)
      most = std::max(most, votes(points_[i], normals_[each.first], found));
    Vector3d best = normals_[i];
    double facing = -2;
    for (const auto& each : found) {
      const Vector3d& normal = normals_[each.first];
      const auto count = static_cast<double>(votes(points_[i], normal, found));
      if (count < kTie * static_cast<double>(most) || normal.dot(towards_) <= facing) continue;
      facing = normal.dot(towards_);
      best = normal;
    }
    return best;
  }

  /// Neighbours on the same face, in the plane at a point [spacings].
  std::vector<Neighbour> neighbours(std::size_t i, double reach, const Vector3d& u,
                                    const Vector3d& v) const {
    std::vector<Neighbour> result;
    const Vector3d& normal = normals_[i];
    for (const auto& [j, squared] : around(i, reach)) {
      if (at_edge_[j] || normals_[j].dot(normal) < kSameFace) continue;
      const Vector3d way = (points_[j] - points_[i]) / spacing_;
      result.push_back({terms(way.dot(u), way.dot(v)), way.dot(normal),
                        std::exp(-2 * squared / std::pow(reach * spacing_, 2))});
    }
    return result;
  }

  /// Fits the heights of the neighbours over the plane at a point with a quadratic function.
  void fit(std::size_t i, SmoothedCloud& result) const {
    constexpr double kOffFace = 0.4;     // spacings below it the point is of no face; chosen
    constexpr double kReachAtEdges = 7;  // spacings: as sure of the slope as amid a face; measured
    const Vector3d normal = normals_[i], u = normal.unitOrthogonal(), v = normal.cross(u);
    std::vector<Neighbour> known = neighbours(i, kReach, u, v);
    if (is_one_sided(known)) known = neighbours(i, kReachAtEdges, u, v);
    const bool is_known = known.size() >= kFewest;
    const Coefficients heights = is_known ? fitted(known) : Coefficients::Zero();
    if (at_edge_[i] && heights[0] > kOffFace) return;
    result.points.push_back(points_[i] + spacing_ * heights[0] * normal);
    result.normals.push_back((normal - heights[1] * u - heights[2] * v).normalized());
  }

  const Points& points_;
  Points normals_;
  const double spacing_;
  const Vector3d towards_;
  const PointTree search_;
  std::vector<bool> at_edge_;
};

}  // namespace

SmoothedCloud smoothed(const tool_path_stretcher::Surface& cloud, const Vector3d& towards) {
  Points normals = cloud.normals;
  for (Vector3d& normal : normals)
    if (normal.dot(towards) < 0) normal = -normal;
  return Smoother(cloud.points, std::move(normals), cloud.spacing, towards).run();
}

}  // namespace part_recipes::path_design
