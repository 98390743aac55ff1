// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "geometry/kd_tree.h"
#include "mapping/deformation.h"

namespace tool_path_stretcher {

/// The scanned points that a graph is fitted to.
struct Target {
  Points points;
  Points normals;
  std::shared_ptr<const KdTree> tree;  //!< null: there are no points
};

/// The object in two halves: alternating blocks of a chequerboard in space. Neighbours share their
/// errors, so holding out single points would not tell noise from shape.
struct Halves {
  Target training;
  Points held_out;
  std::vector<std::size_t> block;  // of each held-out point
  std::size_t blocks = 0;
};

/// The object in two halves, and how far the held-out half lies off the undeformed reference.
struct Trial {
  Halves halves;
  double cut;                   //!< [m, reference] cap of a residual
  std::vector<double> squares;  //!< by block; empty: there is nothing for a graph to explain
};

Trial trial_of(const SurfacePair& surfaces, const Similarity& similarity);

/// Squared residuals of the held-out points that lie on the mapped reference, each capped at the
/// square of the trial's cut, summed by block.
std::vector<double> held_out_squares(const Surface& reference, const Mapping& mapping,
                                     const Trial& trial);

/// Whether the residuals fall noticeably, and over the whole part rather than in a single block.
bool explains_better(const std::vector<double>& before, const std::vector<double>& after);

}  // namespace tool_path_stretcher
