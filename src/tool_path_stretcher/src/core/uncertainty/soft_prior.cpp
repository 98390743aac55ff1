// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/soft_prior.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace tool_path_stretcher {
namespace {

constexpr Eigen::Index kOfNode = GraphEquations::kUnknowns;
constexpr Eigen::Index kMonomials = 9;  // of three coordinates, of degree one and two

/// The monomials at a point, with their gradients in the columns.
struct Monomials {
  Eigen::Matrix<double, kMonomials, 1> values = Eigen::Matrix<double, kMonomials, 1>::Zero();
  Eigen::Matrix<double, 3, kMonomials> gradients = Eigen::Matrix<double, 3, kMonomials>::Zero();
};

Monomials monomials(const Eigen::Vector3d& at) {
  Monomials result;
  Eigen::Index k = 0;
  for (int i = 0; i < 3; ++i, ++k) {
    result.values[k] = at[i];
    result.gradients(i, k) = 1;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j, ++k) {
      result.values[k] = at[i] * at[j];
      result.gradients(i, k) += at[j];
      result.gradients(j, k) += at[i];
    }
  }
  return result;
}

/// [m] Positions of the nodes relative to their mean.
Points nodes_about_middle(const DeformationGraph& graph) {
  Points nodes;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const DeformationGraph::Node& node : graph.nodes()) {
    nodes.push_back(node.at + node.shift);
    middle += nodes.back() / static_cast<double>(graph.nodes().size());
  }
  for (Eigen::Vector3d& node : nodes)
    node -= middle;
  return nodes;
}

/// Removes the mean of the nodes' rotations, then the mean of their shifts.
void take_off_rigid(const Points& nodes, Eigen::Ref<Eigen::VectorXd> mode) {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  const auto count = static_cast<double>(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    turn += mode.segment<3>(kOfNode * static_cast<Eigen::Index>(i)) / count;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Eigen::Index row = kOfNode * static_cast<Eigen::Index>(i);
    mode.segment<3>(row) -= turn;
    mode.segment<3>(row + 3) -= turn.cross(nodes[i]);
    shift += mode.segment<3>(row + 3) / count;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i)
    mode.segment<3>(kOfNode * static_cast<Eigen::Index>(i) + 3) -= shift;
}

}  // namespace

Eigen::MatrixXd smooth_modes(const DeformationGraph& graph) {
  const Points nodes = nodes_about_middle(graph);
  double size = graph.spacing();
  for (const Eigen::Vector3d& node : nodes)
    size = std::max(size, node.norm());
  const auto rows = kOfNode * static_cast<Eigen::Index>(nodes.size()) + 1;
  Eigen::MatrixXd modes = Eigen::MatrixXd::Zero(rows, 3 * kMonomials);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Eigen::Index row = kOfNode * static_cast<Eigen::Index>(i);
    const Monomials of = monomials(nodes[i] / size);
    for (Eigen::Index k = 0; k < kMonomials; ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
        // A node rotates by half of the field's curl.
        modes.block<3, 1>(row, 3 * k + axis) = of.gradients.col(k).cross(unit) / 2;
        modes.block<3, 1>(row + 3, 3 * k + axis) = size * of.values[k] * unit;
      }
    }
  }
  for (Eigen::Index k = 0; k < modes.cols(); ++k)
    take_off_rigid(nodes, modes.col(k));
  return modes;
}

SoftPrior::SoftPrior(const NormalEquations& known, const NormalEquations& rigid,
                     const Eigen::MatrixXd& modes, std::size_t links) {
  const Eigen::MatrixXd stiff = known.matrix + rigid.matrix;
  stiff_ = stiff.sparseView();
  right_side_ = known.right_side + rigid.right_side;
  give_.resize(0, stiff.rows());
  if (modes.cols() == 0 || links == 0) return;
  constexpr double kRidge = 1e-12;  // of the stiffest mode: for modes that move no node
  // The covariances of links and modes add up: the inverse of the sum, by Woodbury's identity.
  const Eigen::MatrixXd pushed = rigid.matrix * modes;
  Eigen::MatrixXd held = (1 + 1 / static_cast<double>(links)) * (modes.transpose() * pushed);
  held.diagonal().array() += kRidge * held.diagonal().maxCoeff();
  const Eigen::LLT<Eigen::MatrixXd> factor(held);
  give_ = factor.matrixL().solve(pushed.transpose());
  right_side_ -= give_.transpose() * factor.matrixL().solve(modes.transpose() * right_side_);
}

NormalEquations SoftPrior::equations() const {
  Eigen::MatrixXd matrix = -give_.transpose() * give_;
  matrix += stiff_;
  return {matrix, right_side_};
}

Eigen::Matrix3d SoftPrior::held(const Eigen::Matrix<double, Eigen::Dynamic, 3>& motions) const {
  const Eigen::Matrix<double, Eigen::Dynamic, 3> given = give_ * motions;
  return motions.transpose() * (stiff_ * motions) - given.transpose() * given;
}

}  // namespace tool_path_stretcher
