// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "mapping/deformation.h"

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
  static constexpr int kUnknowns = 6;  // of a node: turn, shift

  GraphEquations(const DeformationGraph& graph, const Eigen::Vector3d& centre);

  /// Each constraint counts by its deviation [m], and not at all far beyond it.
  void add(const std::vector<GraphConstraint>& constraints, double deviation);

  /// Linked nodes should move each other to where they are (the rigidity term of Sumner 2007).
  /// @param along one standard deviation from that along the link, as a share of its length
  /// @param across the same across the link, where nodes turn
  void add_rigidity(double along, double across);

  /// A linear observation of single unknowns, with its deviation.
  /// @param columns rising
  void add_observation(const std::vector<Eigen::Index>& columns, const std::vector<double>& values,
                       double error, double deviation);

  /// Adds how well the object's scale, now `current`, was known before anything was measured.
  void add_prior(const ScalePrior& prior, double current);

  struct Step {
    Eigen::VectorXd nodes;  // turn and shift of each
    double growth;          // by what share the object is larger than was assumed
    double farthest;        // [m] that a node is shifted
  };
  Step solve() const;

  /// The normal equations: six unknowns a node (turn, shift), then the growth. Of the matrix the
  /// lower triangle.
  const Eigen::MatrixXd& matrix() const { return matrix_; }
  const Eigen::VectorXd& right_side() const { return right_side_; }

 private:
  void add_link(std::size_t from, std::size_t to, const Eigen::Vector3d& arm,
                const Eigen::Vector3d& direction, double strain);

  const DeformationGraph& graph_;
  Eigen::Vector3d centre_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd right_side_;
};

/// What a graph is fitted to: where the mapping puts anchors, and where the scan shows them.
struct GraphObservations {
  std::vector<GraphAnchor> surface;
  std::vector<GraphAnchor> rim;
  std::vector<GraphConstraint> normals;  // of the surface's anchors
  std::vector<GraphConstraint> rims;     // of the rim's
  double normal_deviation;               // [m, reference]
  double rim_deviation;                  // [m, reference]
};

/// What a graph fit of the mapping would see next. The mapping must have nodes.
GraphObservations observe(const SurfacePair& surfaces, const Mapping& mapping);

/// Distance of the nodes of a graph of that level (1 .. 3) [m].
double graph_spacing(const Surface& reference, int level);

/// Moves the nodes.
void take(const GraphEquations::Step& step, DeformationGraph& graph);

}  // namespace tool_path_stretcher
