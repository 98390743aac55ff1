// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/graph_equations.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "geometry/robust.h"

namespace tool_path_stretcher {
namespace {

constexpr int kUnknowns = GraphEquations::kUnknowns;
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
      for (std::size_t j = 0; j <= i; ++j)  // nodes ascend: the lower triangle
        matrix_.block<kUnknowns, kUnknowns>(columns[i], columns[j]).noalias() +=
            weighted * rows[j].transpose();
    }
    right_side_[growth] += weight * grown * constraint.error;
    matrix_(growth, growth) += weight * grown * grown;
  }
}

void GraphEquations::add_rigidity(double along, double across) {
  for (const auto& [from, to] : graph_.links()) {
    const DeformationGraph::Node& node = graph_.nodes()[from];
    const Eigen::Vector3d arm = node.rotation * (graph_.nodes()[to].at - node.at);
    const Eigen::Vector3d link = arm.normalized();
    const Eigen::Vector3d side = link.unitOrthogonal();
    add_link(from, to, arm, link, along);
    add_link(from, to, arm, side, across);
    add_link(from, to, arm, link.cross(side), across);
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
    for (std::size_t j = 0; j <= i; ++j)  // columns ascend: the lower triangle
      matrix_(columns[i], columns[j]) += weighted * values[j];
  }
}

void GraphEquations::add_prior(const ScalePrior& prior, double current) {
  constexpr double kFixed = 1e-12;  // deviation of an exact scale's logarithm; chosen
  if (!prior.is_known()) return;
  const double deviation = prior.is_fixed() ? kFixed : prior.deviation / current;
  const double error = prior.is_fixed() ? 0 : std::log(prior.value / current);
  add_observation({matrix_.rows() - 1}, {1.0}, error, deviation);
}

GraphEquations::Step GraphEquations::solve() const {
  Eigen::MatrixXd matrix = matrix_;
  constexpr double kDamping = 1e-9;  // pins unknowns that neither data nor neighbours show
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
