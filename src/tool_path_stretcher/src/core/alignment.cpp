// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/alignment.h"

#include <algorithm>
#include <cmath>

#include "hypotheses.h"
#include "robust.h"
#include "tool_path_stretcher/residuals.h"

namespace tool_path_stretcher {
namespace {

void sort_best_first(std::vector<Candidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
}

/// The best `most` that differ by more than `least_distance` [m] on the given points.
std::vector<Candidate> distinct(std::vector<Candidate> candidates, const Points& points,
                                double least_distance, std::size_t most) {
  sort_best_first(candidates);
  std::vector<Candidate> kept;
  for (const Candidate& candidate : candidates) {
    if (kept.size() == most) break;
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Candidate& other) {
      return distance(candidate.similarity, other.similarity, points) < least_distance;
    });
    if (!known && std::isfinite(candidate.cost)) kept.push_back(candidate);
  }
  return kept;
}

/// Root mean square residual of both directions, each point counted up to a cap; of the reference
/// only the share that any scan covers.
double cost_of(const Surface& reference, const Surface& object, const Similarity& similarity,
               Density density) {
  constexpr double kCap = 0.05;  // of the object's size
  constexpr double kReferenceShare = 0.5;
  const double cap = kCap * object.size;
  const Mapping mapping{similarity, {}};
  double forth = 0;
  const bool few = density == Density::kFew;
  const Points object_points =
      select(object.points, few ? object.samples.few : object.samples.many);
  for (const Residual& residual : residuals_of(reference, mapping, object_points)) {
    const double distance = similarity.scale * std::hypot(residual.along_normal, residual.beside);
    forth += std::pow(std::min(distance, cap), 2);
  }
  std::vector<double> back;
  for (const std::size_t i : few ? reference.samples.few : reference.samples.many) {
    const double squared = object.tree->nearest(similarity * reference.points[i]).squared_distance;
    back.push_back(std::pow(std::min(std::max(0.0, std::sqrt(squared) - object.spacing), cap), 2));
  }
  std::sort(back.begin(), back.end());
  back.resize(static_cast<std::size_t>(kReferenceShare * static_cast<double>(back.size())) + 1);
  double back_sum = 0;
  for (const double square : back)
    back_sum += square;
  return std::sqrt((forth / static_cast<double>(object_points.size()) +
                    back_sum / static_cast<double>(back.size())) /
                   2);
}

/// The best pose, with the reference turned within itself as a cube is: the poses that a nearly
/// symmetric part is most easily taken for. They must have been looked at before one is believed.
std::vector<Candidate> turned_in_itself(const CoarseSurface& reference, const CoarseSurface& object,
                                        const Candidate& best) {
  constexpr int kIterations = 6;
  const PrincipalFrame& frame = reference.frame;
  std::vector<Candidate> turned;
  for (const Eigen::Matrix3d& turn : cube_turns()) {
    Similarity guess = best.similarity;
    const Eigen::Vector3d centre = guess * frame.centroid;
    guess.rotation = guess.rotation * frame.axes * turn * frame.axes.transpose();
    guess.translation = centre - guess.scale * (guess.rotation * frame.centroid);
    turned.push_back(improve_coarsely(reference, object, guess, kIterations));
  }
  return turned;
}

}  // namespace

std::vector<Candidate> find_candidates(const Surface& reference, const Surface& object,
                                       const AlignmentProgress& progress) {
  const CoarseSurface coarse_reference = coarsen(reference);
  const CoarseSurface coarse_object = coarsen(object);
  const Points& probes = coarse_reference.queries;
  std::vector<Candidate> candidates;
  constexpr std::size_t kPartialGuesses = 40;
  std::vector<Similarity> guesses = first_guesses(coarse_reference.frame, coarse_object.frame);
  for (const Similarity& guess : partial_guesses(coarse_reference, coarse_object, kPartialGuesses))
    guesses.push_back(guess);
  for (const Similarity& guess : guesses) {
    constexpr int kFirstIterations = 4;
    candidates.push_back(
        improve_coarsely(coarse_reference, coarse_object, guess, kFirstIterations));
  }
  progress(0.3);
  candidates = distinct(candidates, probes, 0.1 * object.size, 40);
  for (Candidate& candidate : candidates) {
    constexpr int kMoreIterations = 10;
    candidate =
        improve_coarsely(coarse_reference, coarse_object, candidate.similarity, kMoreIterations);
  }
  progress(0.5);
  candidates = distinct(candidates, probes, 0.05 * object.size, 12);
  const auto refine_all = [&](Density density, int iterations) {
    for (Candidate& candidate : candidates) {
      candidate.similarity =
          refine(reference, object, candidate.similarity, ScaleMode::kFree, density, iterations);
      candidate.cost = cost_of(reference, object, candidate.similarity, density);
    }
  };
  refine_all(Density::kFew, 15);
  progress(0.7);
  candidates = distinct(candidates, probes, 0.03 * object.size, 5);
  if (candidates.empty()) return candidates;
  for (const Candidate& turned :
       turned_in_itself(coarse_reference, coarse_object, candidates.front())) {
    candidates.push_back(turned);
  }
  candidates = distinct(candidates, probes, 0.05 * object.size, 12);
  refine_all(Density::kFew, 10);
  progress(0.85);
  candidates = distinct(candidates, probes, 0.03 * object.size, 5);
  refine_all(Density::kMany, 10);
  candidates = distinct(candidates, probes, 0.01 * object.size, candidates.size());
  progress(1);
  return candidates;
}

}  // namespace tool_path_stretcher
