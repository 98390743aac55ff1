// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "alignment/candidate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cores/by_index.h"
#include "geometry/kd_tree.h"
#include "geometry/points.h"

namespace tool_path_stretcher {
namespace {

double mean_of_least(std::vector<double>& values, double share) {
  const auto end =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size())) + 1;
  std::nth_element(values.begin(), end - 1, values.end());
  return std::accumulate(values.begin(), end, 0.0) / static_cast<double>(end - values.begin());
}

}  // namespace

Candidate judged(const SurfacePair& surfaces, const Mapping& mapping, Density density) {
  constexpr double kCap = 0.05;            // of the object's size; chosen
  constexpr double kObjectShare = 0.9;     // of the object's points; chosen
  constexpr double kBulkShare = 0.75;      // of the object's points; chosen
  constexpr double kReferenceShare = 0.5;  // of the reference's points: a scan shows only one side
  const auto& [reference, object] = surfaces;
  const Similarity& similarity = mapping.similarity;
  const double cap = kCap * object.size;
  std::vector<double> forth;
  for (const Residual& residual :
       residuals_of(reference, mapping, select(object.points, object.samples.of(density)))) {
    const double distance = similarity.scale * std::hypot(residual.along_normal, residual.beside);
    forth.push_back(std::pow(std::min(distance, cap), 2));
  }
  const std::vector<std::size_t>& sample = reference.samples.of(density);
  auto back = by_index<double>(sample.size(), kHundreds, [&](std::size_t k) {
    const Eigen::Vector3d at = mapping * reference.points[sample[k]];
    const double squared = object.tree->nearest(at).squared_distance;
    const double distance = std::max(0.0, std::sqrt(squared) - object.spacing);
    return std::pow(std::min(distance, cap), 2);
  });
  const double of_reference = mean_of_least(back, kReferenceShare);
  const double unresolved = std::pow(resolution(surfaces, similarity.scale), 2);
  Candidate candidate{similarity};
  candidate.cost = std::sqrt((mean_of_least(forth, kObjectShare) + of_reference) / 2 + unresolved);
  candidate.bulk_cost =
      std::sqrt((mean_of_least(forth, kBulkShare) + of_reference) / 2 + unresolved);
  return candidate;
}

}  // namespace tool_path_stretcher
