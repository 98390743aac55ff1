// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "alignment/coarse_fit.h"
#include "surface/border.h"

namespace tool_path_stretcher {

/// Point-to-point ICP in both directions, over the parts where both surfaces are known.
class PartialFit {
 public:
  /// @param surfaces must outlive it, as must coarse
  PartialFit(const SurfacePair& surfaces, const CoarsePair& coarse, const ScaleRange& scales);

  /// Moves the pose, up to `iterations` times, and sets its cost; infinite if too little is known
  /// of both surfaces.
  /// @param stride uses every stride-th of the points looked up
  void improve(Candidate& candidate, int iterations, std::size_t stride) const;

 private:
  /// A thinned surface, and where it ends.
  struct Side {
    struct Found {
      Eigen::Vector3d point;  // [m]
      double distance;        // [m] to that point
      double off;             // [m] to the surface around it
    };

    Side(const Surface& surface, const CoarseSurface& coarse);

    /// The nearest point; none if `at` lies beyond the border.
    std::optional<Found> find(const Eigen::Vector3d& at) const;

    const CoarseSurface& coarse;
    double spacing;  // [m] of the thinned points
    Border border;
  };

  /// A point of the reference and one of the object that may correspond.
  struct Pair {
    Eigen::Vector3d reference;  // [m] in its frame
    Eigen::Vector3d object;     // [m]
    double distance;            // [m, object] between them
  };

  /// Pairs the known points. Returns the cost of the similarity over every `stride`-th point.
  double match(const Similarity& similarity, std::size_t stride, std::vector<Pair>& pairs) const;

  /// Moves the similarity by the nearer pairs. Returns false if there are too few.
  bool move(std::vector<Pair>& pairs, Similarity& similarity) const;

  Side reference_;
  Side object_;
  double size_;
  ScaleRange scales_;
};

}  // namespace tool_path_stretcher
