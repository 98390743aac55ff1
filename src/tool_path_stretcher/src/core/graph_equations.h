// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tool_path_stretcher/deformation.h"
#include "tool_path_stretcher/prior.h"

namespace tool_path_stretcher {

/// A point of the undeformed reference, and what moves it.
struct GraphAnchor {
  Eigen::Vector3d at;     // [m]
  Eigen::Vector3d along;  // unit length: the surface's normal, or out of its rim
  std::vector<DeformationGraph::Influence> influences;
};

/// An anchor that should move by `error` along `direction`, in the reference's frame, beyond where
/// the graph puts it now.
struct GraphConstraint {
  const GraphAnchor* anchor;
  Eigen::Vector3d target;     // [m] where it should come to lie, along the direction
  Eigen::Vector3d direction;  // unit length
  double error;               // [m]
};

/// Normal equations of a step of all nodes (turn and shift of each) and of the object's growth
/// about a centre.
class GraphEquations {
 public:
  GraphEquations(const DeformationGraph& graph, const Eigen::Vector3d& centre);

  /// Each constraint counts by its deviation [m], and not at all far beyond it.
  void add(const std::vector<GraphConstraint>& constraints, double deviation);

  /// Neighbouring nodes should move each other to where they are (the rigidity term of Sumner
  /// 2007): `strain` is how much of their distance they may well be off.
  void add_rigidity(double strain);

  /// The object's scale, now `current`, is known that well before anything was measured.
  void add_prior(const ScalePrior& prior, double current);

  struct Step {
    Eigen::VectorXd nodes;  // turn and shift of each
    double growth;          // by what share the object is larger than was assumed
    double farthest;        // [m] that a node is shifted
  };
  Step solve() const;

 private:
  const DeformationGraph& graph_;
  Eigen::Vector3d centre_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd right_side_;
};

/// Moves the nodes.
void take(const GraphEquations::Step& step, DeformationGraph& graph);

}  // namespace tool_path_stretcher
