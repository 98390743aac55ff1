// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "alignment/coarse_fit.h"

#include <algorithm>
#include <cmath>

#include "geometry/points.h"

namespace tool_path_stretcher {

CoarseSurface::CoarseSurface(const Surface& surface) {
  constexpr std::size_t kQueryPoints = 300;  // chosen
  const Points dense = select(surface.points, surface.samples.few);
  frame = principal_frame(dense);
  queries = select(dense, spread_evenly(dense, kQueryPoints));
  normals = select(surface.normals, surface.samples.few);
  found = std::make_shared<NearestGrid>(dense);
}

namespace {

struct Pair {
  std::size_t query;
  std::size_t match;
  double distance;
};

/// Pairs nearest points in the object's frame, without the worst pairs.
void match(const CoarsePair& surfaces, const Similarity& similarity, std::vector<Pair>& forth,
           std::vector<Pair>& back) {
  // A scan may show only one side of the reference, but nothing that is not on it.
  constexpr double kObjectShare = 0.9;     // of the pairs; chosen
  constexpr double kReferenceShare = 0.6;  // of the pairs; chosen
  const auto& [reference, object] = surfaces;
  forth.clear();
  back.clear();
  for (std::size_t i = 0; i < object.queries.size(); ++i) {
    const Eigen::Vector3d query = similarity.inverse(object.queries[i]);
    const std::size_t nearest = reference.found->nearest(query);
    forth.push_back(
        {i, nearest, similarity.scale * (reference.found->points()[nearest] - query).norm()});
  }
  for (std::size_t i = 0; i < reference.queries.size(); ++i) {
    const Eigen::Vector3d query = similarity * reference.queries[i];
    const std::size_t nearest = object.found->nearest(query);
    back.push_back({i, nearest, (object.found->points()[nearest] - query).norm()});
  }
  const auto keep_nearest = [](std::vector<Pair>& pairs, double share) {
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.query < b.query;
    });
    pairs.resize(static_cast<std::size_t>(std::ceil(share * static_cast<double>(pairs.size()))));
  };
  keep_nearest(forth, kObjectShare);
  keep_nearest(back, kReferenceShare);
}

}  // namespace

Candidate improve_coarsely(const CoarsePair& surfaces, Similarity guess, const ScaleRange& scales,
                           int iterations) {
  const auto& [reference, object] = surfaces;
  std::vector<Pair> forth;
  std::vector<Pair> back;
  for (int i = 0; i < iterations; ++i) {
    match(surfaces, guess, forth, back);
    Points from;
    Points to;
    for (const Pair& pair : forth) {
      from.push_back(reference.found->points()[pair.match]);
      to.push_back(object.queries[pair.query]);
    }
    for (const Pair& pair : back) {
      from.push_back(reference.queries[pair.query]);
      to.push_back(object.found->points()[pair.match]);
    }
    guess = fit_similarity(from, to, scales);
  }
  match(surfaces, guess, forth, back);
  const auto mean_square = [](const std::vector<Pair>& pairs) {
    double sum = 0;
    for (const Pair& pair : pairs)
      sum += pair.distance * pair.distance;
    return sum / static_cast<double>(pairs.size());
  };
  const double cost = std::sqrt((mean_square(forth) + mean_square(back)) / 2);
  return {guess, cost, cost};
}

}  // namespace tool_path_stretcher
