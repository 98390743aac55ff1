// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "search/partial_search.h"

#include <algorithm>
#include <cmath>

#include "alignment/partial_cost.h"
#include "alignment/partial_fit.h"
#include "alignment/refinement.h"
#include "geometry/kd_tree.h"
#include "geometry/points.h"
#include "geometry/robust.h"
#include "search/guesses.h"
#include "search/search_engine.h"

namespace tool_path_stretcher {
namespace {

/// [m] robust standard deviation of the points from the planes of their neighbours
double roughness(const Surface& surface) {
  constexpr std::size_t kNeighbours = 13;  // twelve, and the point itself; chosen
  std::vector<double> distances;
  std::vector<KdTree::Neighbour> neighbours;
  for (const std::size_t i : surface.samples.few) {
    surface.tree->nearest(surface.points[i], kNeighbours, neighbours);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const KdTree::Neighbour& neighbour : neighbours)
      mean += surface.points[neighbour.index];
    mean /= static_cast<double>(neighbours.size());
    distances.push_back(surface.normals[i].dot(surface.points[i] - mean));
  }
  return robust_deviation(std::move(distances));
}

/// Whether a part may have this scale. Otherwise an axis was matched to a wrong one.
bool is_sane(double scale) {
  constexpr double kLeast = 0.4;  // chosen: a little beyond min_scale and max_scale
  constexpr double kMost = 2.5;
  return scale > kLeast && scale < kMost;
}

}  // namespace

const std::vector<Candidate>& PartialSearch::fits() {
  if (!fits_) fits_ = search();
  return *fits_;
}

std::vector<Candidate> PartialSearch::search() {
  constexpr std::size_t kProbes = 30;  // points; chosen
  const CoarsePair coarse(surfaces_);
  const PartialFit fit(surfaces_, coarse, prior_.scale.range());
  const Comparison& compare = comparison();
  const Eigen::Vector3d& middle = coarse.reference.frame.centroid;
  const auto improve = [&](const Round& round, Candidate& each) {
    if (!round.density) {
      fit.improve(each, round.iterations, round.stride);
      return true;
    }
    each.similarity =
        refine(surfaces_, each.similarity, prior_.scale, *round.density, round.iterations);
    if (*round.density == Density::kFewest) {
      fit.improve(each, 0, round.stride);
      return true;
    }
    each.agreement = compare.under({each.similarity, {}});
    each.cost = each.agreement->cost;
    return each.agreement->known >= kLeastKnown && is_sane(each.similarity.scale) &&
           prior_.allows(each.similarity, middle);
  };
  std::vector<Similarity> guesses = overlapping_guesses(coarse);
  if (prior_.pose) {
    const std::vector<Similarity> given = guesses_about(prior_, coarse);
    guesses.insert(guesses.end(), given.begin(), given.end());
  }
  std::vector<Candidate> fits;
  for (const Similarity& guess : guesses) {
    const Similarity sized = clamped(guess, prior_.scale.range(), middle);
    if (is_sane(sized.scale)) fits.push_back({sized});
  }
  const Points& points = coarse.reference.queries;
  const SearchEngine engine(select(points, spread_evenly(points, kProbes)), surfaces_.object.size,
                            improve);
  for (const Round& round : kPartialRounds)
    engine.run(round, fits);
  return fits;
}

Agreement PartialSearch::agreement(const Mapping& mapping) {
  return comparison().under(mapping);
}

const Comparison& PartialSearch::comparison() {
  if (!comparison_) comparison_.emplace(surfaces_);
  return *comparison_;
}

bool PartialSearch::is_certain() {
  if (!certain_) certain_ = !fits().empty() && agrees_to_the_noise(fits().front());
  return *certain_;
}

bool PartialSearch::agrees_to_the_noise(const Candidate& best) const {
  constexpr double kAgreeing = 0.95;      // of the points known; chosen
  constexpr double kContradicted = 0.02;  // of the points known; chosen
  constexpr double kRough = 2;            // times the roughness of both surfaces; chosen
  const double scale = best.similarity.scale;
  const double rough =
      std::max(std::hypot(scale * roughness(surfaces_.reference), roughness(surfaces_.object)),
               resolution(surfaces_, scale));
  return best.agreement->agreeing >= kAgreeing &&
         best.agreement->contradicted(best.agreement->noise) <= kContradicted &&
         best.agreement->noise <= kRough * rough;
}

}  // namespace tool_path_stretcher
