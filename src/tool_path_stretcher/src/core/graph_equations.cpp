// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "graph_equations.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "robust.h"

namespace tool_path_stretcher {
namespace {

constexpr Eigen::Index kUnknowns = 6;  // of a node: turn, shift

Eigen::Matrix3d small_turn(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

}  // namespace

GraphEquations::GraphEquations(const DeformationGraph& graph, const Eigen::Vector3d& centre)
    : graph_(graph), centre_(centre) {
  const Eigen::Index size = kUnknowns * static_cast<Eigen::Index>(graph.nodes().size()) + 1;
  matrix_ = Eigen::MatrixXd::Zero(size, size);
  right_side_ = Eigen::VectorXd::Zero(size);
}

void GraphEquations::add_row(const std::vector<Eigen::Index>& columns,
                             const std::vector<double>& values, double error, double weight) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double weighted = weight * values[i];
    right_side_[columns[i]] += weighted * error;
    for (std::size_t j = 0; j <= i; ++j)  // the columns rise: the lower triangle
      matrix_(columns[i], columns[j]) += weighted * values[j];
  }
}

void GraphEquations::add(const std::vector<GraphConstraint>& constraints, double deviation) {
  std::vector<Eigen::Index> columns;
  std::vector<double> values;
  for (const GraphConstraint& constraint : constraints) {
    const double weight =
        tukey_weight(constraint.error, kTukeyCut * deviation) / (deviation * deviation);
    if (weight == 0) continue;
    columns.clear();
    values.clear();
    for (const auto& influence : constraint.anchor->influences) {
      const DeformationGraph::Node& node = graph_.nodes()[influence.node];
      const Eigen::Vector3d arm = node.rotation * (constraint.anchor->at - node.at);
      const Eigen::Vector3d turn = influence.weight * arm.cross(constraint.direction);
      const Eigen::Vector3d shift = influence.weight * constraint.direction;
      const Eigen::Index column = kUnknowns * static_cast<Eigen::Index>(influence.node);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        columns.push_back(column + axis);
        values.push_back(turn[axis]);
      }
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        columns.push_back(column + 3 + axis);
        values.push_back(shift[axis]);
      }
    }
    columns.push_back(matrix_.rows() - 1);
    values.push_back(constraint.direction.dot(constraint.target - centre_));
    add_row(columns, values, constraint.error, weight);
  }
}

void GraphEquations::add_rigidity(double strain) {
  constexpr double kNeighbours = 1.8;  // spacings
  const std::vector<DeformationGraph::Node>& nodes = graph_.nodes();
  const double reach = kNeighbours * graph_.spacing();
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Eigen::Vector3d way = nodes[k].at - nodes[j].at;
      if (j == k || way.norm() > reach) continue;
      const double deviation = strain * way.norm();
      const Eigen::Vector3d arm = nodes[j].rotation * way;
      const Eigen::Vector3d error =
          nodes[k].at + nodes[k].shift - (arm + nodes[j].at + nodes[j].shift);
      const Eigen::Index from = kUnknowns * static_cast<Eigen::Index>(j);
      const Eigen::Index to = kUnknowns * static_cast<Eigen::Index>(k);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d turn = arm.cross(Eigen::Vector3d::Unit(axis));
        std::vector<Eigen::Index> columns = {from, from + 1, from + 2, from + 3 + axis};
        std::vector<double> values = {turn.x(), turn.y(), turn.z(), 1.0};
        const auto at = to < from ? columns.begin() : columns.end();
        values.insert(to < from ? values.begin() : values.end(), -1.0);
        columns.insert(at, to + 3 + axis);
        add_row(columns, values, error[axis], 1 / (deviation * deviation));
      }
    }
  }
}

void GraphEquations::add_prior(const ScalePrior& prior, double current) {
  constexpr double kFixed = 1e-12;
  if (!prior.is_known()) return;
  const double deviation = prior.is_fixed() ? kFixed : prior.deviation / current;
  add_row({matrix_.rows() - 1}, {1.0}, prior.is_fixed() ? 0 : std::log(prior.value / current),
          1 / (deviation * deviation));
}

GraphEquations::Step GraphEquations::solve() const {
  Eigen::MatrixXd matrix = matrix_;
  constexpr double kDamping = 1e-9;  // pins what neither data nor neighbours show
  matrix.diagonal() *= 1 + kDamping;
  matrix.diagonal().array() += kDamping;
  Eigen::VectorXd step = matrix.selfadjointView<Eigen::Lower>().ldlt().solve(right_side_);
  if (!step.allFinite()) step.setZero();
  double farthest = 0;
  for (Eigen::Index at = 0; at + kUnknowns < step.size(); at += kUnknowns)
    farthest = std::max(farthest, step.segment<3>(at + 3).norm());
  return {step.head(step.size() - 1), step[step.size() - 1], farthest};
}

void take(const GraphEquations::Step& step, DeformationGraph& graph) {
  Eigen::Index at = 0;
  for (DeformationGraph::Node& node : graph.nodes()) {
    const Eigen::Matrix3d turn = small_turn(step.nodes.segment<3>(at));
    node.rotation = Eigen::Quaterniond(turn * node.rotation).normalized().toRotationMatrix();
    node.shift += step.nodes.segment<3>(at + 3);
    at += kUnknowns;
  }
}

}  // namespace tool_path_stretcher
