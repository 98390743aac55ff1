// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "search/scale_search.h"

#include <cmath>

#include "alignment/refinement.h"
#include "geometry/points.h"
#include "mapping/residuals.h"

namespace tool_path_stretcher {
namespace {

constexpr int kIterations = 6;  // per scale; chosen

/// The start, scaled about the object's centre.
Similarity at_scale(const Similarity& start, double scale, const Eigen::Vector3d& centre) {
  const double growth = scale / start.scale;
  return {scale, start.rotation, centre + growth * (start.translation - centre)};
}

/// Shares of inliers in both directions, measured in the object's frame so that a shrunken
/// reference gains nothing. Nearer inliers count more, since many scales reach all of them.
double score_of(const SurfacePair& surfaces, const Similarity& similarity, double inlier_distance) {
  const Explanation explanation = explain(surfaces, {similarity, {}}, inlier_distance);
  const auto share = [inlier_distance](const std::vector<double>& distances) {
    double sum = 0;
    for (const double distance : distances) {
      const double relative = distance / inlier_distance;
      if (relative < 1) sum += 1 - relative * relative;  // false for NaN too
    }
    return sum / static_cast<double>(distances.size());
  };
  return share(explanation.object.off) + share(explanation.reference.off);
}

struct Scored {
  Similarity similarity;
  double score = -1;
  int index = 0;
};

/// Tries scale (1 + range i / steps), i = -steps .. steps, both ends included.
Scored sweep(const SurfacePair& surfaces, const Similarity& start, double scale, double range,
             int steps, double inlier_distance) {
  const Eigen::Vector3d centre = surfaces.object.centroid;
  Scored best;
  for (int i = -steps; i <= steps; ++i) {
    const double tried = scale * (1 + range * i / static_cast<double>(steps));
    const Similarity similarity =
        refine(surfaces, at_scale(start, tried, centre), {tried, 0}, Density::kFew, kIterations);
    const double score = score_of(surfaces, similarity, inlier_distance);
    if (score > best.score) best = {similarity, score, i};
  }
  return best;
}

}  // namespace

double principal_scale(const SurfacePair& surfaces) {
  const auto deviation = [](const Surface& surface) {
    return principal_frame(select(surface.points, surface.samples.many)).deviation[0];
  };
  return deviation(surfaces.object) / deviation(surfaces.reference);
}

ScaleSearch search_scale(const SurfacePair& surfaces, const Similarity& start, double scale,
                         double range, int steps, double inlier_distance,
                         const AlignmentProgress& progress) {
  const Scored rough = sweep(surfaces, start, scale, range, steps, inlier_distance);
  progress(0.5);
  const Scored fine = sweep(surfaces, rough.similarity, rough.similarity.scale, range / steps,
                            steps, inlier_distance);
  progress(1);
  return {fine.similarity, std::abs(rough.index) == steps};
}

}  // namespace tool_path_stretcher
