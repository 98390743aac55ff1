// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "edits/shapes.h"

#include <cmath>
#include <limits>

#include "geometry/clusters.h"

namespace cloud_preprocess {
namespace {

template <class Test>
std::vector<bool> where(const Cloud& cloud, const Test& test) {
  std::vector<bool> in(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    in[i] = test(Eigen::Vector3d(cloud[i].getVector3fMap().cast<double>()));
  return in;
}

/// The two axes of the picture seen when looking along -towards.
Eigen::Matrix<double, 2, 3> picture_axes(const Eigen::Vector3d& towards) {
  Eigen::Matrix<double, 2, 3> axes;
  axes.row(0) = towards.unitOrthogonal().transpose();
  axes.row(1) = towards.cross(Eigen::Vector3d(axes.row(0).transpose())).transpose();
  return axes;
}

/// Even-odd rule: a ray along +x from the point crosses an odd number of edges. An edge includes
/// its lower end but not its upper one, so that a corner counts once.
bool is_in_polygon(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& point) {
  bool inside = false;
  for (std::size_t i = 0, before = corners.size() - 1; i < corners.size(); before = i++) {
    const Eigen::Vector2d& a = corners[before];
    const Eigen::Vector2d& b = corners[i];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double crossing = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (point.x() < crossing) inside = !inside;
  }
  return inside;
}

}  // namespace

std::vector<bool> points_in(const Cloud& cloud, const BoxShape& box) {
  const Eigen::Isometry3d to_box = box.pose.inverse();
  return where(cloud, [&](const Eigen::Vector3d& point) {
    return ((to_box * point).array().abs() <= box.size.array() / 2).all();
  });
}

std::vector<bool> points_in(const Cloud& cloud, const HalfSpace& half) {
  return where(cloud, [&](const Eigen::Vector3d& point) {
    return half.normal.dot(point - half.point) >= 0;
  });
}

std::vector<bool> points_in(const Cloud& cloud, const PrismShape& prism) {
  const auto axes = picture_axes(prism.towards);
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector3d& corner : prism.corners)
    corners.emplace_back(axes * corner);
  return where(cloud, [&](const Eigen::Vector3d& point) {
    const double depth = prism.towards.dot(prism.corners.front() - point);
    return depth >= prism.nearest && depth <= prism.farthest &&
           is_in_polygon(corners, axes * point);
  });
}

std::vector<bool> points_in(const Cloud& cloud, const BrushShape& brush) {
  const KdTree tree(cloud);
  std::vector<bool> in(cloud.size(), false);
  std::vector<std::pair<KdTree::Index, float>> near;
  for (const Eigen::Vector3d& place : brush.places) {
    const Eigen::Vector3f at = place.cast<float>();
    tree.within(at.data(), static_cast<float>(brush.radius * brush.radius), near);
    for (const auto& [point, squared] : near)
      in[point] = true;
  }
  return in;
}

std::vector<bool> points_in(const Cloud& cloud, const ClusterShape& cluster) {
  std::vector<bool> in(cloud.size(), false);
  KdTree::Index nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double distance =
        (cloud[i].getVector3fMap().cast<double>() - cluster.place).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    nearest = static_cast<KdTree::Index>(i);
  }
  if (cloud.empty() || least > cluster.gap * cluster.gap) return in;
  for (const KdTree::Index i : cluster_of(cloud, cluster.gap, nearest))
    in[i] = true;
  return in;
}

const char* name_of(const CloudEdit& edit) {
  constexpr const char* kNames[] = {"box", "plane", "polygon", "brush", "cluster"};
  return kNames[edit.shape.index()];
}

}  // namespace cloud_preprocess
