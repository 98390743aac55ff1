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
/// Schmid and Pauly 2007). Each node rotates and shifts the space around it; between nodes these
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
    double weight;  //!< the weights at a point sum to 1
  };

  DeformationGraph() = default;  ///< no displacement

  /// Spreads nodes over the points, about `spacing` [m] apart; they do not displace anything yet.
  DeformationGraph(const Points& points, double spacing);

  bool empty() const { return nodes_.empty(); }
  double spacing() const { return spacing_; }
  std::vector<Node>& nodes() { return nodes_; }
  const std::vector<Node>& nodes() const { return nodes_; }

  /// Pairs of neighbouring nodes, each in both orders.
  std::vector<std::pair<std::size_t, std::size_t>> links() const;

  /// The nodes that move a point; at least one, however far away the point is.
  void influences(const Eigen::Vector3d& point, std::vector<Influence>& found) const;

  /// Derivatives of their weights along a direction [1/m].
  std::vector<double> weight_slopes(const Eigen::Vector3d& point, const Eigen::Vector3d& way,
                                    const std::vector<Influence>& influences) const;

  /// A point as moved by these nodes.
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

  /// The point in the reference's space that is mapped onto `point` in the object's.
  Eigen::Vector3d pull_back(const Eigen::Vector3d& point) const;

  /// The rotation of the surface with that normal at a point of the reference: the rotation nearest
  /// to the mapping's derivative, corrected so that the normal stays normal to the surface.
  Eigen::Matrix3d turn(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const;
};

/// Follows a smooth deformation of the object, if there is one. Graphs of levels 1 to
/// `finest_level`, each finer than the last, are fitted to one half of the scan (in blocks). Each
/// is kept only if it explains the other half better, so that noise is not followed. Without such a
/// graph the mapping has none; otherwise its similarity is the one nearest to the whole mapping.
Mapping fit_deformation(const SurfacePair& surfaces, const Similarity& similarity,
                        const ScalePrior& scale, int finest_level);

/// The same with a coarser and softer graph, fitted to that half of the scan only: less work, for
/// comparing poses.
Mapping sketch_deformation(const SurfacePair& surfaces, const Similarity& similarity,
                           const ScalePrior& scale, int finest_level);

}  // namespace tool_path_stretcher
