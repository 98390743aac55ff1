// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "mapping/deformation.h"

namespace tool_path_stretcher {

/// A point of the undeformed reference and the nodes that move it.
struct GraphAnchor {
  Eigen::Vector3d at;     // [m]
  Eigen::Vector3d along;  // unit length: the surface's normal, or outwards from its rim
  std::vector<DeformationGraph::Influence> influences;
};

/// An anchor that should move by `error` along `direction` from where the graph puts it now, in the
/// reference's frame.
struct GraphConstraint {
  const GraphAnchor* anchor;
  Eigen::Vector3d target;     // [m] where it should be, along the direction
  Eigen::Vector3d direction;  // unit length
  double error;               // [m]
};

/// Normal equations for a step of all nodes (rotation and shift of each) and the object's growth
/// about a centre.
class GraphEquations {
 public:
  static constexpr int kUnknowns = 6;  // per node: rotation, shift

  GraphEquations(const DeformationGraph& graph, const Eigen::Vector3d& centre);

  /// Weights each constraint by the deviation [m]; errors far beyond it do not count.
  void add(const std::vector<GraphConstraint>& constraints, double deviation);

  /// Linked nodes should predict each other's positions (the rigidity term of Sumner 2007).
  /// @param along one standard deviation along the link, as a share of its length
  /// @param across the same across the link, where nodes rotate
  void add_rigidity(double along, double across);

  /// Adds a linear observation of individual unknowns, with its deviation.
  /// @param columns ascending
  void add_observation(const std::vector<Eigen::Index>& columns, const std::vector<double>& values,
                       double error, double deviation);

  /// Adds the prior knowledge of the object's scale, which is now `current`.
  void add_prior(const ScalePrior& prior, double current);

  struct Step {
    Eigen::VectorXd nodes;  // rotation and shift of each
    double growth;          // share by which the object is larger than assumed
    double farthest;        // [m] largest shift of a node
  };
  Step solve() const;

  /// The normal equations: six unknowns per node (rotation, shift), then the growth. Only the lower
  /// triangle of the matrix.
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

/// The observations a graph is fitted to: where the mapping puts anchors, and where the scan shows
/// them.
struct GraphObservations {
  std::vector<GraphAnchor> surface;
  std::vector<GraphAnchor> rim;
  std::vector<GraphConstraint> normals;  // of the surface's anchors
  std::vector<GraphConstraint> rims;     // of the rim's
  double normal_deviation;               // [m, reference]
  double rim_deviation;                  // [m, reference]
};

/// The observations for the next graph fit of the mapping, which must have nodes.
GraphObservations observe(const SurfacePair& surfaces, const Mapping& mapping);

/// Node spacing of a graph of that level (1 .. 3) [m].
double graph_spacing(const Surface& reference, int level);

/// Applies the step to the nodes.
void take(const GraphEquations::Step& step, DeformationGraph& graph);

}  // namespace tool_path_stretcher
