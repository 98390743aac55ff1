// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "alignment/candidate.h"
#include "geometry/nearest_grid.h"
#include "geometry/points.h"

namespace tool_path_stretcher {

/// A surface thinned for the search over all poses.
struct CoarseSurface {
  explicit CoarseSurface(const Surface& surface);

  PrincipalFrame frame;
  Points queries;                      //!< at most 300 points to look up in the other surface
  std::shared_ptr<NearestGrid> found;  //!< at most 1000 points that can be found
  Points normals;                      //!< of `found`, unit length
};

struct CoarsePair {
  explicit CoarsePair(const SurfacePair& surfaces)
      : reference(surfaces.reference), object(surfaces.object) {}

  CoarseSurface reference;
  CoarseSurface object;
};

/// Point-to-point ICP in both directions, without the farthest pairs (trimmed ICP, Chetverikov
/// 2002).
Candidate improve_coarsely(const CoarsePair& surfaces, Similarity guess, const ScaleRange& scales,
                           int iterations);

}  // namespace tool_path_stretcher
