// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "alignment/agreement.h"

#include <algorithm>
#include <cmath>

#include "alignment/partial_cost.h"
#include "geometry/kd_tree.h"
#include "geometry/robust.h"

namespace tool_path_stretcher {
namespace {

constexpr double kOnSurface = 1.5;  // spacings of the sparser surface; chosen

double share_within(const std::vector<double>& distances, double most) {
  if (distances.empty()) return 1;
  const auto count = std::count_if(distances.begin(), distances.end(),
                                   [most](double distance) { return distance <= most; });
  return static_cast<double>(count) / static_cast<double>(distances.size());
}

/// Whether a point is off a surface by more than the rounding of an edge between two of its points.
bool is_clear(const Surface& surface, const Eigen::Vector3d& point, double from_nearest) {
  constexpr double kNear = 2;  // spacings; chosen
  const double near = kNear * surface.spacing;
  if (from_nearest > near || !surface.rim.tree) return true;
  return surface.rim.tree->nearest(point).squared_distance > near * near;
}

}  // namespace

double Agreement::contradicted(double deviation) const {
  constexpr double kDeviations = 5;  // standard: 1 in 2 million of normal noise
  const double most = kDeviations * deviation;
  return 1 - std::min(share_within(object_off, most), share_within(reference_off, most));
}

/// The known points of one surface on the other.
struct Comparison::Known {
  std::size_t all = 0;            // points, known or not
  std::vector<double> distances;  // [m, object]
  std::vector<double> off;        // [m, object] 0 where an edge may be the cause

  /// @param at in the frame of `surface`, which is `scale` times larger in the object's
  void add(const Surface& surface, const Border& border, const Eigen::Vector3d& at, double scale) {
    ++all;
    const std::size_t nearest = surface.tree->nearest(at).index;
    const Eigen::Vector3d way = at - surface.points[nearest];
    if (border.is_beyond(at, nearest, way.norm())) return;
    const double distance = off_surface(way, surface.normals[nearest], surface.spacing);
    distances.push_back(scale * distance);
    constexpr double kOff = 0.1;  // spacings; chosen
    const bool blamed = distance > kOff * surface.spacing && !is_clear(surface, at, way.norm());
    off.push_back(blamed ? 0 : scale * distance);
  }

  double share() const { return static_cast<double>(off.size()) / static_cast<double>(all); }
};

Comparison::Comparison(const SurfacePair& surfaces)
    : surfaces_(surfaces),
      reference_border_(surfaces.reference, surfaces.reference.points, surfaces.reference.spacing),
      object_border_(surfaces.object, surfaces.object.points, surfaces.object.spacing) {}

Comparison::Known Comparison::object_on_reference(const Mapping& mapping) const {
  Known known;
  for (const std::size_t i : surfaces_.object.samples.many) {
    known.add(surfaces_.reference, reference_border_, mapping.pull_back(surfaces_.object.points[i]),
              mapping.similarity.scale);
  }
  return known;
}

Comparison::Known Comparison::reference_on_object(const Mapping& mapping) const {
  Known known;
  for (const std::size_t i : surfaces_.reference.samples.many)
    known.add(surfaces_.object, object_border_, mapping * surfaces_.reference.points[i], 1);
  return known;
}

Agreement Comparison::under(const Mapping& mapping) const {
  const double tolerance =
      kOnSurface *
      std::max(mapping.similarity.scale * surfaces_.reference.spacing, surfaces_.object.spacing);
  Known forth = object_on_reference(mapping);
  Known back = reference_on_object(mapping);
  PartialCost cost(surfaces_.object.size);
  for (const auto* distances : {&forth.distances, &back.distances}) {
    for (const double distance : *distances)
      cost.add(distance);
  }
  Agreement agreement;
  agreement.object_known = forth.share();
  agreement.known = std::min(forth.share(), back.share());
  agreement.agreeing =
      std::min(share_within(forth.distances, tolerance), share_within(back.distances, tolerance));
  agreement.noise =
      std::max(robust_deviation(forth.off), resolution(surfaces_, mapping.similarity.scale));
  agreement.cost = cost.of(static_cast<double>(forth.all + back.all));
  agreement.object_off = std::move(forth.off);
  agreement.reference_off = std::move(back.off);
  return agreement;
}

}  // namespace tool_path_stretcher
