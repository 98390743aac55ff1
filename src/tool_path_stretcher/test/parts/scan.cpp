// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parts/scan.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace cases {
namespace {

/// Samples by area and keeps the points that this scan sees.
class Scanner {
 public:
  Scanner(const Part& part, const Scan& how) : part_(part), how_(how), engine_(how.seed) {
    double sum = 0;
    for (const Facet& facet : part.facets) {
      sum += facet.area;
      area_to_.push_back(sum);
      for (const double u : {0.0, 1.0})
        for (const double v : {0.0, 1.0})
          box_.extend(facet.at(u, v).position);
    }
  }

  /// A point of the undeformed part.
  Eigen::Vector3d seen() {
    for (int tries = 0; tries < 100000; ++tries) {
      const double at = uniform() * area_to_.back();
      const auto found = std::lower_bound(area_to_.begin(), area_to_.end(), at);
      const Facet& facet = part_.facets[static_cast<std::size_t>(found - area_to_.begin())];
      const double u = uniform();
      const SurfacePoint point = facet.at(u, uniform());
      if (sees(point)) return point.position;
    }
    throw std::logic_error("nothing of the part is seen");
  }

  Eigen::Vector3d outlier() {
    const Eigen::Vector3d share(uniform(), uniform(), uniform());
    return box_.min() - 0.1 * box_.diagonal() + 1.2 * box_.diagonal().cwiseProduct(share);
  }

  /// A point beside the part, in the plane it stands on.
  Eigen::Vector3d floor() {
    const double x = box_.min().x() + uniform() * box_.sizes().x();
    return {x, box_.max().y() + (0.03 + 0.25 * uniform()) * box_.sizes().y(), box_.min().z()};
  }

  Eigen::Vector3d noise() {
    std::normal_distribution<double> normal(0, how_.noise);
    const double x = normal(engine_), y = normal(engine_);
    return {x, y, normal(engine_)};
  }

 private:
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(engine_); }

  bool sees(const SurfacePoint& point) {
    constexpr double kFacing = 0.25;
    if (how_.from_above && point.normal.z() < kFacing) return false;
    const Eigen::Vector3d at = (point.position - box_.min()).cwiseQuotient(box_.sizes());
    if ((how_.far_end ? 1 - at.x() : at.x()) > how_.share) return false;
    const double density = 1 + (how_.density_ratio - 1) * at.y();
    if (uniform() * std::max(1.0, how_.density_ratio) > density) return false;
    return how_.hole == 0 || away_from_holes(point.position);
  }

  bool away_from_holes(const Eigen::Vector3d& at) const {
    const double apart = part_.size / 1.5;
    const Eigen::Vector2d cell(std::remainder(at.x() - 0.01, apart),
                               std::remainder(at.y() - 0.013, apart));
    return cell.norm() > how_.hole;
  }

  const Part& part_;
  const Scan& how_;
  std::mt19937 engine_;
  std::vector<double> area_to_;
  Eigen::AlignedBox3d box_;
};

}  // namespace

Points scan(const Part& part, const Deformation& deformation, const Similarity& similarity,
            const Scan& how) {
  Scanner scanner(part, how);
  const auto outliers = static_cast<std::size_t>(how.outliers * static_cast<double>(how.points));
  const std::size_t floor = how.floor ? how.points / 10 : 0;
  Points points;
  for (std::size_t i = 0; i < how.points; ++i) {
    const bool loose = i < outliers;
    const bool on_floor = !loose && i < outliers + floor;
    const Eigen::Vector3d at = loose      ? scanner.outlier()
                               : on_floor ? scanner.floor()
                                          : deformation(scanner.seen());
    points.push_back(similarity * at + scanner.noise());
  }
  return points;
}

ToolPath truth(const ToolPath& path, const Deformation& deformation, const Similarity& similarity) {
  ToolPath result = path;
  for (auto& segment : result.segments) {
    for (auto& waypoint : segment.waypoints) {
      waypoint.pose = deformed(deformation, waypoint.pose);
      waypoint.pose.translation() = similarity * waypoint.pose.translation();
      waypoint.pose.linear() = similarity.rotation * waypoint.pose.linear();
    }
  }
  return result;
}

PathError error_of(const ToolPath& path, const ToolPath& truth,
                   const std::vector<bool>& counted_along) {
  PathError sum;
  double count = 0;
  double along_count = 0;
  for (std::size_t s = 0; s < truth.segments.size(); ++s) {
    for (std::size_t w = 0; w < truth.segments[s].waypoints.size(); ++w) {
      const Eigen::Isometry3d& is = path.segments.at(s).waypoints.at(w).pose;
      const Eigen::Isometry3d& should = truth.segments[s].waypoints[w].pose;
      const Eigen::Vector3d off = is.translation() - should.translation();
      const double normal = off.dot(should.linear().col(2));
      const double angle = Eigen::AngleAxisd(is.linear().transpose() * should.linear()).angle();
      sum.normal += normal * normal;
      sum.orientation += angle * angle;
      sum.worst = std::max(sum.worst, off.norm());
      const auto index = static_cast<std::size_t>(count);
      count += 1;
      if (!counted_along.empty() && !counted_along.at(index)) continue;
      sum.tangential += off.squaredNorm() - normal * normal;
      along_count += 1;
    }
  }
  return {std::sqrt(sum.normal / count), std::sqrt(sum.tangential / std::max(1.0, along_count)),
          std::sqrt(sum.orientation / count), sum.worst};
}

Eigen::Matrix3d random_rotation(unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal(0, 1);
  const double w = normal(engine), x = normal(engine), y = normal(engine);
  return Eigen::Quaterniond(w, x, y, normal(engine)).normalized().toRotationMatrix();
}

}  // namespace cases
