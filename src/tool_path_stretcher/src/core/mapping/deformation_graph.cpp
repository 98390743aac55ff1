// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/points.h"
#include "mapping/deformation.h"

namespace tool_path_stretcher {

DeformationGraph::DeformationGraph(const Points& points, double spacing) : spacing_(spacing) {
  for (const Eigen::Vector3d& at : reduce_on_grid(points, Eigen::Vector3d::Constant(spacing))) {
    Node node;
    node.at = at;
    nodes_.push_back(node);
  }
}

namespace {

constexpr double kReach = 1.8;  // spacings: nodes beside each other, also across a cell; chosen
constexpr double kStep = 1e-3;  // spacings, of central differences; chosen

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> DeformationGraph::links() const {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t from = 0; from < nodes_.size(); ++from) {
    for (std::size_t to = 0; to < nodes_.size(); ++to) {
      if (from != to && (nodes_[to].at - nodes_[from].at).norm() <= kReach * spacing_) {
        result.emplace_back(from, to);
      }
    }
  }
  return result;
}

void DeformationGraph::influences(const Eigen::Vector3d& point,
                                  std::vector<Influence>& found) const {
  constexpr double kBeyond = 1.5;  // times the nearest node's distance, for points far off; chosen
  double nearest = std::numeric_limits<double>::infinity();
  for (const Node& node : nodes_)
    nearest = std::min(nearest, (node.at - point).squaredNorm());
  const double reach = std::max(kReach * kReach * spacing_ * spacing_, kBeyond * kBeyond * nearest);
  found.clear();
  double sum = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double share = 1 - (nodes_[i].at - point).squaredNorm() / reach;
    if (share <= 0) continue;
    found.push_back({i, share * share * share});
    sum += found.back().weight;
  }
  for (Influence& influence : found)
    influence.weight /= sum;
}

std::vector<double> DeformationGraph::weight_slopes(
    const Eigen::Vector3d& point, const Eigen::Vector3d& way,
    const std::vector<Influence>& influences) const {
  std::vector<double> weights(nodes_.size(), 0);
  std::vector<Influence> found;
  const double step = kStep * spacing_;
  for (const double side : {-1.0, 1.0}) {
    this->influences(point + side * step * way, found);
    for (const Influence& influence : found)
      weights[influence.node] += side * influence.weight / (2 * step);
  }
  std::vector<double> slopes;
  for (const Influence& influence : influences)
    slopes.push_back(weights[influence.node]);
  return slopes;
}

Eigen::Vector3d DeformationGraph::moved(const Eigen::Vector3d& point,
                                        const std::vector<Influence>& influences) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Influence& influence : influences) {
    const Node& node = nodes_[influence.node];
    sum += influence.weight * (node.rotation * (point - node.at) + node.at + node.shift);
  }
  return sum;
}

Eigen::Vector3d DeformationGraph::displacement(const Eigen::Vector3d& point) const {
  if (empty()) return Eigen::Vector3d::Zero();
  thread_local std::vector<Influence> found;
  influences(point, found);
  return moved(point, found) - point;
}

Eigen::Matrix3d DeformationGraph::jacobian(const Eigen::Vector3d& point) const {
  if (empty()) return Eigen::Matrix3d::Zero();
  const double step = kStep * spacing_;
  Eigen::Matrix3d result;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d way = step * Eigen::Vector3d::Unit(axis);
    result.col(axis) = (displacement(point + way) - displacement(point - way)) / (2 * step);
  }
  return result;
}

Eigen::Vector3d Mapping::pull_back(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d target = similarity.inverse(point);
  if (graph.empty()) return target;
  constexpr int kIterations = 4;  // the field is smooth and small: each gains one to two digits
  Eigen::Vector3d result = target;
  for (int i = 0; i < kIterations; ++i)
    result = target - graph.displacement(result);
  return result;
}

Eigen::Matrix3d Mapping::turn(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const {
  if (graph.empty()) return similarity.rotation;
  const Eigen::Matrix3d local = Eigen::Matrix3d::Identity() + graph.jacobian(point);
  const Eigen::Matrix3d nearest = nearest_rotation(local);
  // A shear turns a surface further than the rotation nearest to it.
  const Eigen::Vector3d turned = local.inverse().transpose() * normal;
  const auto rest = Eigen::Quaterniond::FromTwoVectors(nearest * normal, turned);
  return similarity.rotation * rest.toRotationMatrix() * nearest;
}

}  // namespace tool_path_stretcher
