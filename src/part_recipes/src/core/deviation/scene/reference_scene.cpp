// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "deviation/scene/reference_scene.h"

#include <limits>

#include "deviation/deviations.h"
#include "tool_path_stretcher/surface.h"

namespace part_recipes {
namespace {

using tool_path_stretcher::Surface;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void add_rim(const Surface& surface, ReferenceScene& scene) {
  constexpr std::size_t kMost = 20000;  // points that a page may draw; chosen
  const Points& rim = surface.rim.points;
  for (std::size_t i = 0; i < rim.size(); i += 1 + rim.size() / kMost) {
    scene.points.push_back(rim[i]);
    scene.scanned.push_back(kNaN);
    scene.rim.push_back(1);
  }
}

}  // namespace

ReferenceScene load_reference_scene(
    const std::string& reference, double metres_per_unit,
    const std::optional<tool_path_stretcher::Similarity>& similarity, const Points& object,
    double tolerance) {
  const Eigen::Vector3d leaf(0.002, 0.002, 0.0005);  // [m] the stretcher's own grid
  const Surface surface = tool_path_stretcher::load_surface(reference, leaf, metres_per_unit);
  ReferenceSurface::Samples samples;
  samples.spacing = surface.spacing;
  for (const std::size_t i : surface.samples.most) {
    samples.points.push_back(surface.points[i]);
    samples.normals.push_back(surface.normals[i]);
  }
  ReferenceScene scene{samples.points, std::vector<double>(samples.points.size(), kNaN),
                       std::vector<double>(samples.points.size(), 0)};
  if (similarity) {
    const Reach reach = reach_of(tolerance, spacing_of(object));
    const std::vector<bool> seen = scanned(samples, *similarity, object, reach);
    scene.scanned.assign(seen.begin(), seen.end());
  }
  add_rim(surface, scene);
  if (!similarity) return scene;
  for (Eigen::Vector3d& point : scene.points)
    point = *similarity * point;
  return scene;
}

}  // namespace part_recipes
