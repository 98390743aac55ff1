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
  std::shared_ptr<const KdTree> tree;  //!< none: there are none
};

/// The object in two halves: every other block of a chequerboard in space. Neighbours share their
/// errors, so that single points held out would not tell noise from shape.
struct Halves {
  Target training;
  Points held_out;
  std::vector<std::size_t> block;  // of each point held out
  std::size_t blocks = 0;
};

/// The object in two halves, and how far the one held out lies off the reference as it is.
struct Trial {
  Halves halves;
  double cut;                   //!< [m, reference] of a residual
  std::vector<double> squares;  //!< by block; none: there is nothing for a graph to explain
};

Trial trial_of(const SurfacePair& surfaces, const Similarity& similarity);

/// Square residuals of the points held out that lie on the mapped reference, each up to the square
/// of the trial's cut, summed by block.
std::vector<double> held_out_squares(const Surface& reference, const Mapping& mapping,
                                     const Trial& trial);

/// Whether the residuals fall by more than a little, and over the whole of the part rather than in
/// one block of it.
bool explains_better(const std::vector<double>& before, const std::vector<double>& after);

}  // namespace tool_path_stretcher
