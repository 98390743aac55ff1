// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/residuals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cores/by_index.h"
#include "geometry/kd_tree.h"
#include "geometry/robust.h"

namespace tool_path_stretcher {
namespace {

/// A mapped point of the reference relative to the scanned surface.
struct FromScan {
  double off;           // [m] NaN where it was not scanned
  std::size_t nearest;  // point of the object
};

FromScan from_scan(const Surface& object, const Eigen::Vector3d& point) {
  constexpr double kReach = 2.5;  // spacings over which the scanned surface is known; chosen
  const KdTree::Neighbour nearest = object.tree->nearest(point);
  const double along = object.normals[nearest.index].dot(point - object.points[nearest.index]);
  const double beside = std::sqrt(std::max(0.0, nearest.squared_distance - along * along));
  const bool known = beside <= kReach * object.spacing;
  return {known ? std::abs(along) : std::numeric_limits<double>::quiet_NaN(), nearest.index};
}

/// Empty distances for the surface's sample, to be filled in.
Distances distances_of(const Surface& surface) {
  const std::vector<double> none(surface.samples.most.size());
  return {none, none, surface.samples.patch};
}

Distances object_distances(const SurfacePair& surfaces, const Mapping& mapping) {
  const auto& [reference, object] = surfaces;
  const std::vector<std::size_t>& sample = object.samples.most;
  Distances distances = distances_of(object);
  const double scale = mapping.similarity.scale;
  for_indices(sample.size(), kHundreds, [&](std::size_t k) {
    const std::size_t i = sample[k];
    const Residual residual = residual_of(reference, mapping, object.points[i]);
    distances.off[k] = scale * std::hypot(residual.along_normal, residual.beside);
    distances.blur[k] = scale * reference.blur[residual.reference] + object.blur[i];
  });
  return distances;
}

Distances reference_distances(const SurfacePair& surfaces, const Mapping& mapping) {
  const auto& [reference, object] = surfaces;
  const std::vector<std::size_t>& sample = reference.samples.most;
  Distances distances = distances_of(reference);
  for_indices(sample.size(), kHundreds, [&](std::size_t k) {
    const std::size_t i = sample[k];
    const FromScan from = from_scan(object, mapping * reference.points[i]);
    distances.off[k] = from.off;
    distances.blur[k] = mapping.similarity.scale * reference.blur[i] + object.blur[from.nearest];
  });
  return distances;
}

/// Whether a point lies on the other surface, to within noise, sampling and grid.
bool is_explained(const Distances& distances, std::size_t i, double noise) {
  constexpr double kDeviations = 3;  // standard: 0.3 % of normal noise
  return distances.off[i] <= std::max(kDeviations * noise, distances.blur[i]);
}

/// The count over the points of one patch.
struct PatchLead {
  double lead = 0;
  double points = 0;
};

PatchLead& patch_of(const Distances& distances, std::size_t i, std::vector<PatchLead>& patches) {
  if (distances.patch[i] >= patches.size()) patches.resize(distances.patch[i] + 1);
  patches[distances.patch[i]].points += 1;
  return patches[distances.patch[i]];
}

/// Adds the evidence from the points of one surface.
void add(const Distances& first, const Distances& second, double noise, Evidence& sum) {
  constexpr double kMost = 0.5;  // of the points of a patch; chosen
  std::vector<PatchLead> patches;
  for (std::size_t i = 0; i < first.off.size(); ++i) {
    if (std::isnan(first.off[i]) || std::isnan(second.off[i])) continue;
    patch_of(first, i, patches).lead += static_cast<double>(is_explained(first, i, noise)) -
                                        static_cast<double>(is_explained(second, i, noise));
  }
  for (const PatchLead& patch : patches) {
    if (patch.points == 0) continue;
    const double share = patch.lead / patch.points;
    (share > 0 ? sum.only_first : sum.only_second) += std::abs(share);
    if (std::abs(share) > kMost) (share > 0 ? sum.patches_first : sum.patches_second) += 1;
    sum.squares += share * share;
    sum.compared += 1;
  }
}

}  // namespace

Residual residual_of(const Surface& reference, const Mapping& mapping,
                     const Eigen::Vector3d& object_point) {
  Residual residual;
  residual.pulled_back = mapping.pull_back(object_point);
  const KdTree::Neighbour nearest = reference.tree->nearest(residual.pulled_back);
  residual.reference = nearest.index;
  residual.along_normal =
      reference.normals[nearest.index].dot(residual.pulled_back - reference.points[nearest.index]);
  const double beside = std::sqrt(
      std::max(0.0, nearest.squared_distance - residual.along_normal * residual.along_normal));
  residual.beside = std::max(0.0, beside - reference.spacing);
  return residual;
}

std::vector<Residual> residuals_of(const Surface& reference, const Mapping& mapping,
                                   const Points& object_points) {
  return by_index<Residual>(object_points.size(), kHundreds, [&](std::size_t i) {
    return residual_of(reference, mapping, object_points[i]);
  });
}

Explanation explain(const SurfacePair& surfaces, const Mapping& mapping, double inlier_distance) {
  const auto& [reference, object] = surfaces;
  Explanation result;
  double squares = 0;
  std::size_t inliers = 0;
  result.object = object_distances(surfaces, mapping);
  for (const double distance : result.object.off) {
    if (distance > inlier_distance) continue;
    squares += distance * distance;
    ++inliers;
  }
  result.reference = reference_distances(surfaces, mapping);
  const auto covered = std::count_if(result.reference.off.begin(), result.reference.off.end(),
                                     [=](double off) { return off <= inlier_distance; });
  result.noise =
      std::max(robust_deviation(result.object.off), resolution(surfaces, mapping.similarity.scale));
  result.rms = inliers == 0 ? 0 : std::sqrt(squares / static_cast<double>(inliers));
  result.inlier_ratio =
      static_cast<double>(inliers) / static_cast<double>(object.samples.most.size());
  result.overlap =
      static_cast<double>(covered) / static_cast<double>(reference.samples.most.size());
  return result;
}

Fitted fitted(const SurfacePair& surfaces, const Mapping& mapping, double inlier_distance) {
  return {mapping, explain(surfaces, mapping, inlier_distance)};
}

double resolution(const SurfacePair& surfaces, double scale) {
  constexpr double kShare = 0.025;  // of both spacings; chosen
  return kShare * (scale * surfaces.reference.spacing + surfaces.object.spacing);
}

Evidence evidence(const Explanation& first, const Explanation& second) {
  Evidence sum;
  const double noise = std::min(first.noise, second.noise);
  add(first.object, second.object, noise, sum);
  add(first.reference, second.reference, noise, sum);
  return sum;
}

double unexplained_patches(const Explanation& explanation) {
  double count = 0;
  for (const Distances* distances : {&explanation.object, &explanation.reference}) {
    std::vector<PatchLead> patches;
    for (std::size_t i = 0; i < distances->off.size(); ++i) {
      if (std::isnan(distances->off[i])) continue;
      patch_of(*distances, i, patches).lead += !is_explained(*distances, i, explanation.noise);
    }
    for (const PatchLead& patch : patches)
      count += patch.lead > patch.points / 2;
  }
  return count;
}

bool explains_all(const Explanation& explanation) {
  constexpr double kFew = 12;  // patches: 3.5 squared, the significance of clearly_better
  return unexplained_patches(explanation) < kFew;
}

bool clearly_better(const Explanation& better, const Explanation& other) {
  constexpr double kSignificance = 3.5;  // standard deviations of the count: 1 in 4,000 by chance
  constexpr double kMinShare = 5e-4;     // of the patches compared; chosen
  const Evidence found = evidence(better, other);
  const double lead = found.only_first - found.only_second;
  return lead > kSignificance * std::sqrt(found.squares) && lead > kMinShare * found.compared;
}

}  // namespace tool_path_stretcher
