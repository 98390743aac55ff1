// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "surface/surface_pair.h"
#include "tool_path_stretcher/prior.h"
#include "tool_path_stretcher/similarity.h"

namespace tool_path_stretcher {

/// A smooth displacement of the reference, in its own frame: an embedded deformation graph (Sumner,
/// Schmid and Pauly 2007). Each node turns and shifts the space around it; between the nodes the
/// motions are blended.
class DeformationGraph {
 public:
  struct Node {
    Eigen::Vector3d at;  //!< [m] in the undeformed reference
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();  //!< [m]
  };
  struct Influence {
    std::size_t node;
    double weight;  //!< of all at a point, the sum is 1
  };

  DeformationGraph() = default;  ///< no displacement

  /// Nodes spread over the points, about `spacing` [m] apart, that do not displace anything yet.
  DeformationGraph(const Points& points, double spacing);

  bool empty() const { return nodes_.empty(); }
  double spacing() const { return spacing_; }
  std::vector<Node>& nodes() { return nodes_; }
  const std::vector<Node>& nodes() const { return nodes_; }

  /// Pairs of neighbouring nodes, each in both orders.
  std::vector<std::pair<std::size_t, std::size_t>> links() const;

  /// The nodes that move a point. At least one, however far away it is.
  void influences(const Eigen::Vector3d& point, std::vector<Influence>& found) const;

  /// How their weights change along a way [1/m].
  std::vector<double> weight_slopes(const Eigen::Vector3d& point, const Eigen::Vector3d& way,
                                    const std::vector<Influence>& influences) const;

  /// Where a point comes to lie that those nodes move.
  Eigen::Vector3d moved(const Eigen::Vector3d& point,
                        const std::vector<Influence>& influences) const;

  Eigen::Vector3d displacement(const Eigen::Vector3d& point) const;
  Eigen::Matrix3d jacobian(const Eigen::Vector3d& point) const;  ///< of the displacement

 private:
  double spacing_ = 0;
  std::vector<Node> nodes_;
};

/// Reference to object: p_object = similarity * (p + graph.displacement(p)).
struct Mapping {
  Similarity similarity;
  DeformationGraph graph;

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return similarity * (point + graph.displacement(point));
  }

  /// The point of the reference's space that comes to lie on `point` of the object's.
  Eigen::Vector3d pull_back(const Eigen::Vector3d& point) const;

  /// How the surface with that normal at a point of the reference is turned: by the rotation
  /// nearest to the mapping's derivative, then so that the normal stays normal to the surface.
  Eigen::Matrix3d turn(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const;
};

/// Follows a smooth deformation of the object, where one is there: graphs of 1 to `finest_level`,
/// each finer than the one before, are fitted to one half of the scan (in blocks) and kept only
/// while they explain the other half better, so that noise is not followed. No graph if none does;
/// otherwise the similarity is the one nearest to the whole mapping.
Mapping fit_deformation(const SurfacePair& surfaces, const Similarity& similarity,
                        const ScalePrior& scale, int finest_level);

/// The same with a coarser and softer graph, fitted to that one half of the scan only: less work,
/// to compare poses by.
Mapping sketch_deformation(const SurfacePair& surfaces, const Similarity& similarity,
                           const ScalePrior& scale, int finest_level);

}  // namespace tool_path_stretcher
