// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "search/partial_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/robust.h"
#include "search/overlapping_guesses.h"
#include "search/partial_cost.h"

namespace tool_path_stretcher {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// A surface thinned, and where it ends.
struct Side {
  explicit Side(const Surface& surface)
      : coarse(coarsen(surface)),
        spacing(surface.spacing * std::sqrt(static_cast<double>(surface.points.size()) /
                                            static_cast<double>(surface.samples.few.size()))),
        border(surface, coarse.found->points(), spacing) {}

  struct Found {
    Eigen::Vector3d point;  // [m]
    double distance;        // [m] to it
    double off;             // [m] to the surface about it
  };

  /// The nearest point; none where `at` lies beyond the border.
  std::optional<Found> find(const Eigen::Vector3d& at) const {
    const std::size_t nearest = coarse.found->nearest(at);
    const Eigen::Vector3d& point = coarse.found->points()[nearest];
    const double distance = (at - point).norm();
    if (distance > spacing && border.is_beyond(at, nearest, distance)) return {};
    return Found{point, distance, off_surface(at - point, coarse.normals[nearest], spacing)};
  }

  CoarseSurface coarse;
  double spacing;  // [m] of the thinned points
  Border border;
};

/// A point of the reference and one of the object that may be the same.
struct Pair {
  Eigen::Vector3d reference;  // [m] in its frame
  Eigen::Vector3d object;     // [m]
  double distance;            // [m, object] between them
};

/// Point-to-point ICP in both directions, over what is known of both surfaces.
class CoarseFit {
 public:
  CoarseFit(const Surface& reference, const Surface& object, const ScaleRange& scales)
      : reference_(reference), object_(object), size_(object.size), scales_(scales) {}

  const CoarseSurface& reference() const { return reference_.coarse; }
  const CoarseSurface& object() const { return object_.coarse; }

  /// @param step of the points looked up: every one, every second ...
  PartialFit rated(const Similarity& similarity, std::size_t step = 1) {
    PartialFit fit{similarity, {}};
    fit.agreement.cost = match(similarity, step);
    return fit;
  }

  PartialFit improved(Similarity similarity, int iterations, std::size_t step = 1) {
    for (int i = 0; i < iterations; ++i) {
      match(similarity, step);
      if (!fit(similarity)) break;
    }
    return rated(similarity, step);
  }

 private:
  /// Pairs what is known. The cost of the similarity, of every `step`-th point.
  double match(const Similarity& similarity, std::size_t step) {
    pairs_.clear();
    PartialCost cost(size_);
    const Points& object_points = object_.coarse.queries;
    for (std::size_t i = 0; i < object_points.size(); i += step) {
      const auto found = reference_.find(similarity.inverse(object_points[i]));
      if (!found) continue;
      cost.add(similarity.scale * found->off);
      pairs_.push_back({found->point, object_points[i], similarity.scale * found->distance});
    }
    const std::size_t forth = pairs_.size();
    const Points& reference_points = reference_.coarse.queries;
    for (std::size_t i = 0; i < reference_points.size(); i += step) {
      const auto found = object_.find(similarity * reference_points[i]);
      if (!found) continue;
      cost.add(found->off);
      pairs_.push_back({reference_points[i], found->point, found->distance});
    }
    const double all_forth =
        std::ceil(static_cast<double>(object_points.size()) / static_cast<double>(step));
    const double all_back =
        std::ceil(static_cast<double>(reference_points.size()) / static_cast<double>(step));
    const double known = std::min(static_cast<double>(forth) / all_forth,
                                  static_cast<double>(pairs_.size() - forth) / all_back);
    return known < kLeastKnown ? kNever : cost.of(all_forth + all_back);
  }

  /// Moves the similarity by the nearer pairs.
  bool fit(Similarity& similarity) {
    constexpr double kShare = 0.85;
    constexpr std::size_t kFewest = 20;
    if (pairs_.size() < kFewest) return false;
    const auto end =
        pairs_.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(pairs_.size()));
    std::nth_element(pairs_.begin(), end, pairs_.end(),
                     [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    Points from;
    Points to;
    for (auto pair = pairs_.begin(); pair != end; ++pair) {
      from.push_back(pair->reference);
      to.push_back(pair->object);
    }
    similarity = fit_similarity(from, to, scales_);
    return true;
  }

  Side reference_;
  Side object_;
  double size_;
  ScaleRange scales_;
  std::vector<Pair> pairs_;
};

bool is_better(const PartialFit& a, const PartialFit& b) {
  return a.agreement.cost < b.agreement.cost;
}

void keep_best(std::vector<PartialFit>& fits, std::size_t most) {
  std::stable_sort(fits.begin(), fits.end(), is_better);
  if (fits.size() > most) fits.resize(most);
}

/// The best `most` that differ by more than `least_distance` [m] on the probes.
void keep_distinct(std::vector<PartialFit>& fits, const Points& probes, double least_distance,
                   std::size_t most) {
  std::stable_sort(fits.begin(), fits.end(), is_better);
  std::vector<PartialFit> kept;
  for (const PartialFit& each : fits) {
    if (kept.size() == most || each.agreement.cost == kNever) break;
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const PartialFit& other) {
      return distance(each.similarity, other.similarity, probes) < least_distance;
    });
    if (!known) kept.push_back(each);
  }
  fits = std::move(kept);
}

/// [m] robust standard deviation of the points from the planes of their neighbours
double roughness(const Surface& surface) {
  constexpr std::size_t kNeighbours = 13;  // the point itself is one
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

bool is_sane(double scale) {
  constexpr double kLeast = 0.4;
  constexpr double kMost = 2.5;
  return scale > kLeast && scale < kMost;
}

}  // namespace

const std::vector<PartialFit>& PartialSearch::fits() {
  if (!searched_) search();
  searched_ = true;
  return fits_;
}

void PartialSearch::search() {
  constexpr std::size_t kProbes = 30;
  constexpr std::size_t kGlance = 12;  // every twelfth point, at first
  constexpr std::size_t kLook = 4;
  CoarseFit coarse(reference_, object_, prior_.scale.range());
  const Points& points = coarse.reference().queries;
  const Points probes = select(points, spread_evenly(points, kProbes));
  const Eigen::Vector3d& middle = coarse.reference().frame.centroid;
  const double near = 0.05 * object_.size;
  std::vector<Similarity> guesses = overlapping_guesses(coarse.reference(), coarse.object());
  if (prior_.pose) {
    const auto given = guesses_about(prior_, coarse.reference().frame, coarse.object().frame);
    guesses.insert(guesses.end(), given.begin(), given.end());
  }
  for (const Similarity& guess : guesses) {
    const Similarity sized = clamped(guess, prior_.scale.range(), middle);
    if (is_sane(sized.scale)) fits_.push_back(coarse.rated(sized, kGlance));
  }
  keep_best(fits_, 2500);
  for (PartialFit& each : fits_)
    each = coarse.rated(each.similarity, kLook);
  keep_distinct(fits_, probes, near, 500);
  for (PartialFit& each : fits_)
    each = coarse.improved(each.similarity, 4, kLook);
  keep_distinct(fits_, probes, near, 100);
  for (PartialFit& each : fits_)
    each = coarse.improved(each.similarity, 10);
  keep_distinct(fits_, probes, near, 60);
  for (PartialFit& each : fits_) {
    each = coarse.rated(
        refine(reference_, object_, each.similarity, prior_.scale, Density::kFewest, 6));
  }
  keep_distinct(fits_, probes, 0.03 * object_.size, 10);
  for (PartialFit& each : fits_) {
    each.similarity = refine(reference_, object_, each.similarity, prior_.scale, Density::kFew, 15);
    each.agreement = agreement({each.similarity, {}});
    const bool allowed = each.agreement.known >= kLeastKnown && is_sane(each.similarity.scale) &&
                         prior_.allows(each.similarity, middle);
    if (!allowed) each.agreement.cost = kNever;
  }
  keep_distinct(fits_, probes, 0.03 * object_.size, 6);
}

Agreement PartialSearch::agreement(const Mapping& mapping) {
  if (!comparison_) comparison_.emplace(reference_, object_);
  return comparison_->under(mapping);
}

bool PartialSearch::is_certain() {
  if (!certain_) certain_ = !fits().empty() && agrees_to_the_noise();
  return *certain_;
}

bool PartialSearch::agrees_to_the_noise() const {
  constexpr double kAgreeing = 0.95;
  constexpr double kContradicted = 0.02;
  constexpr double kRough = 2;  // times the roughness of both surfaces
  const PartialFit& best = fits_.front();
  const double scale = best.similarity.scale;
  const double rough = std::max(std::hypot(scale * roughness(reference_), roughness(object_)),
                                resolution(reference_, object_, scale));
  return best.agreement.agreeing >= kAgreeing &&
         best.agreement.contradicted(best.agreement.noise) <= kContradicted &&
         best.agreement.noise <= kRough * rough;
}

}  // namespace tool_path_stretcher
