// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "graph_equations.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "robust.h"

namespace tool_path_stretcher {
namespace {

constexpr int kUnknowns = 6;         // of a node: turn, shift
constexpr double kNeighbours = 1.8;  // spacings
using NodeRow = Eigen::Matrix<double, kUnknowns, 1>;

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

void GraphEquations::add(const std::vector<GraphConstraint>& constraints, double deviation) {
  const Eigen::Index growth = matrix_.rows() - 1;
  std::vector<Eigen::Index> columns;
  std::vector<NodeRow> rows;
  for (const GraphConstraint& constraint : constraints) {
    const double weight =
        tukey_weight(constraint.error, kTukeyCut * deviation) / (deviation * deviation);
    if (weight == 0) continue;
    columns.clear();
    rows.clear();
    for (const auto& influence : constraint.anchor->influences) {
      const DeformationGraph::Node& node = graph_.nodes()[influence.node];
      const Eigen::Vector3d arm = node.rotation * (constraint.anchor->at - node.at);
      columns.push_back(kUnknowns * static_cast<Eigen::Index>(influence.node));
      rows.emplace_back();
      rows.back() << influence.weight * arm.cross(constraint.direction),
          influence.weight * constraint.direction;
    }
    const double grown = constraint.direction.dot(constraint.target - centre_);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const NodeRow weighted = weight * rows[i];
      right_side_.segment<kUnknowns>(columns[i]) += constraint.error * weighted;
      matrix_.block<1, kUnknowns>(growth, columns[i]) += grown * weighted.transpose();
      for (std::size_t j = 0; j <= i; ++j)  // nodes rise: the lower triangle
        matrix_.block<kUnknowns, kUnknowns>(columns[i], columns[j]).noalias() +=
            weighted * rows[j].transpose();
    }
    right_side_[growth] += weight * grown * constraint.error;
    matrix_(growth, growth) += weight * grown * grown;
  }
}

void GraphEquations::add_rigidity(double strain) {
  using Block = Eigen::Matrix<double, 3, kUnknowns>;
  const std::vector<DeformationGraph::Node>& nodes = graph_.nodes();
  const double reach = kNeighbours * graph_.spacing();
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Eigen::Vector3d way = nodes[k].at - nodes[j].at;
      if (j == k || way.norm() > reach) continue;
      const double deviation = strain * way.norm();
      const double weight = 1 / (deviation * deviation);
      const Eigen::Vector3d arm = nodes[j].rotation * way;
      const Eigen::Vector3d error =
          nodes[k].at + nodes[k].shift - (arm + nodes[j].at + nodes[j].shift);
      Block from = Block::Zero();
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        from.block<1, 3>(axis, 0) = arm.cross(Eigen::Vector3d::Unit(axis)).transpose();
      from.rightCols<3>().setIdentity();
      Block to = Block::Zero();
      to.rightCols<3>() = -Eigen::Matrix3d::Identity();
      const Eigen::Index at = kUnknowns * static_cast<Eigen::Index>(j);
      const Eigen::Index other = kUnknowns * static_cast<Eigen::Index>(k);
      const auto add_block = [&](Eigen::Index row, const Block& left, Eigen::Index column,
                                 const Block& right) {
        matrix_.block<kUnknowns, kUnknowns>(row, column) += weight * left.transpose() * right;
      };
      add_block(at, from, at, from);
      add_block(other, to, other, to);
      if (at > other) add_block(at, from, other, to);
      if (at < other) add_block(other, to, at, from);
      right_side_.segment<kUnknowns>(at) += weight * from.transpose() * error;
      right_side_.segment<kUnknowns>(other) += weight * to.transpose() * error;
    }
  }
}

void GraphEquations::add_rigidity(double along, double across) {
  const std::vector<DeformationGraph::Node>& nodes = graph_.nodes();
  const double reach = kNeighbours * graph_.spacing();
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Eigen::Vector3d way = nodes[k].at - nodes[j].at;
      if (j == k || way.norm() > reach) continue;
      const Eigen::Vector3d arm = nodes[j].rotation * way;
      const Eigen::Vector3d link = arm.normalized();
      const Eigen::Vector3d side = link.unitOrthogonal();
      add_link(j, k, arm, link, along);
      add_link(j, k, arm, side, across);
      add_link(j, k, arm, link.cross(side), across);
    }
  }
}

void GraphEquations::add_link(std::size_t from, std::size_t to, const Eigen::Vector3d& arm,
                              const Eigen::Vector3d& direction, double strain) {
  const DeformationGraph::Node& a = graph_.nodes()[from];
  const DeformationGraph::Node& b = graph_.nodes()[to];
  const Eigen::Index from_column = kUnknowns * static_cast<Eigen::Index>(from);
  const Eigen::Index to_column = kUnknowns * static_cast<Eigen::Index>(to);
  const Eigen::Vector3d turn = arm.cross(direction);
  std::vector<Eigen::Index> columns;
  std::vector<double> values;
  const auto add_from = [&] {
    for (Eigen::Index axis = 0; axis < kUnknowns; ++axis) {
      columns.push_back(from_column + axis);
      values.push_back(axis < 3 ? turn[axis] : direction[axis - 3]);
    }
  };
  if (from < to) add_from();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    columns.push_back(to_column + 3 + axis);
    values.push_back(-direction[axis]);
  }
  if (from > to) add_from();
  add_observation(columns, values, direction.dot(b.at + b.shift - (arm + a.at + a.shift)),
                  strain * arm.norm());
}

void GraphEquations::add_observation(const std::vector<Eigen::Index>& columns,
                                     const std::vector<double>& values, double error,
                                     double deviation) {
  const double weight = 1 / (deviation * deviation);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double weighted = weight * values[i];
    right_side_[columns[i]] += weighted * error;
    for (std::size_t j = 0; j <= i; ++j)  // the columns rise: the lower triangle
      matrix_(columns[i], columns[j]) += weighted * values[j];
  }
}

void GraphEquations::add_prior(const ScalePrior& prior, double current) {
  constexpr double kFixed = 1e-12;
  if (!prior.is_known()) return;
  const double deviation = prior.is_fixed() ? kFixed : prior.deviation / current;
  const double error = prior.is_fixed() ? 0 : std::log(prior.value / current);
  const double weight = 1 / (deviation * deviation);
  const Eigen::Index growth = matrix_.rows() - 1;
  matrix_(growth, growth) += weight;
  right_side_[growth] += weight * error;
}

GraphEquations::Step GraphEquations::solve() const {
  Eigen::MatrixXd matrix = matrix_;
  constexpr double kDamping = 1e-9;  // pins what neither data nor neighbours show
  matrix.diagonal() *= 1 + kDamping;
  matrix.diagonal().array() += kDamping;
  Eigen::VectorXd step = matrix.selfadjointView<Eigen::Lower>().llt().solve(right_side_);
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
