// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surface/surface_pair.h"
#include "tool_path_stretcher/prior.h"

namespace tool_path_stretcher {

/// Refines a pose by robust point-to-plane ICP in both directions (Chen and Medioni 1992; Tukey's
/// biweight), with rims matched to rims. The scale of the start must lie in the prior's range.
Similarity refine(const SurfacePair& surfaces, Similarity start, const ScalePrior& scale,
                  Density density, int iterations);

/// The pose with the reference moved by about `step` [m], both ways, along each of the two
/// directions that the surfaces resist least.
std::vector<Similarity> slides(const SurfacePair& surfaces, const Similarity& similarity,
                               double step);

/// A line in the object's space [m], its direction of unit length.
struct Axis {
  Eigen::Vector3d at;
  Eigen::Vector3d along;
};

/// The axes, at most two, about which the surfaces resist a rotation of the reference least.
std::vector<Axis> freest_axes(const SurfacePair& surfaces, const Similarity& similarity);

}  // namespace tool_path_stretcher
