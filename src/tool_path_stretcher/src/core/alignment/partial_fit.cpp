// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "alignment/partial_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "alignment/partial_cost.h"

namespace tool_path_stretcher {

PartialFit::Side::Side(const Surface& surface, const CoarseSurface& thinned)
    : coarse(thinned),
      spacing(surface.spacing * std::sqrt(static_cast<double>(surface.points.size()) /
                                          static_cast<double>(surface.samples.few.size()))),
      border(surface, thinned.found->points(), spacing) {}

std::optional<PartialFit::Side::Found> PartialFit::Side::find(const Eigen::Vector3d& at) const {
  const std::size_t nearest = coarse.found->nearest(at);
  const Eigen::Vector3d& point = coarse.found->points()[nearest];
  const double distance = (at - point).norm();
  if (distance > spacing && border.is_beyond(at, nearest, distance)) return {};
  return Found{point, distance, off_surface(at - point, coarse.normals[nearest], spacing)};
}

PartialFit::PartialFit(const SurfacePair& surfaces, const CoarsePair& coarse,
                       const ScaleRange& scales)
    : reference_(surfaces.reference, coarse.reference),
      object_(surfaces.object, coarse.object),
      size_(surfaces.object.size),
      scales_(scales) {}

void PartialFit::improve(Candidate& candidate, int iterations, std::size_t stride) const {
  std::vector<Pair> pairs;
  candidate.cost = match(candidate.similarity, stride, pairs);
  for (int i = 0; i < iterations && move(pairs, candidate.similarity); ++i)
    candidate.cost = match(candidate.similarity, stride, pairs);
}

double PartialFit::match(const Similarity& similarity, std::size_t stride,
                         std::vector<Pair>& pairs) const {
  pairs.clear();
  PartialCost cost(size_);
  const Points& object_points = object_.coarse.queries;
  for (std::size_t i = 0; i < object_points.size(); i += stride) {
    const auto found = reference_.find(similarity.inverse(object_points[i]));
    if (!found) continue;
    cost.add(similarity.scale * found->off);
    pairs.push_back({found->point, object_points[i], similarity.scale * found->distance});
  }
  const std::size_t forth = pairs.size();
  const Points& reference_points = reference_.coarse.queries;
  for (std::size_t i = 0; i < reference_points.size(); i += stride) {
    const auto found = object_.find(similarity * reference_points[i]);
    if (!found) continue;
    cost.add(found->off);
    pairs.push_back({reference_points[i], found->point, found->distance});
  }
  const double all_forth =
      std::ceil(static_cast<double>(object_points.size()) / static_cast<double>(stride));
  const double all_back =
      std::ceil(static_cast<double>(reference_points.size()) / static_cast<double>(stride));
  const double known = std::min(static_cast<double>(forth) / all_forth,
                                static_cast<double>(pairs.size() - forth) / all_back);
  return known < kLeastKnown ? std::numeric_limits<double>::infinity()
                             : cost.of(all_forth + all_back);
}

bool PartialFit::move(std::vector<Pair>& pairs, Similarity& similarity) const {
  constexpr double kShare = 0.85;      // of the pairs; chosen
  constexpr std::size_t kFewest = 20;  // pairs; chosen
  if (pairs.size() < kFewest) return false;
  const auto end =
      pairs.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(pairs.size()));
  std::nth_element(pairs.begin(), end, pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  Points from;
  Points to;
  for (auto pair = pairs.begin(); pair != end; ++pair) {
    from.push_back(pair->reference);
    to.push_back(pair->object);
  }
  similarity = fit_similarity(from, to, scales_);
  return true;
}

}  // namespace tool_path_stretcher
