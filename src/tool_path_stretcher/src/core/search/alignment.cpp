// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "search/alignment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/robust.h"
#include "search/hypotheses.h"
#include "search/partial_search.h"
#include "search/turns.h"
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

double mean_of_least(std::vector<double>& values, double share) {
  const auto end =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size())) + 1;
  std::nth_element(values.begin(), end - 1, values.end());
  return std::accumulate(values.begin(), end, 0.0) / static_cast<double>(end - values.begin());
}

/// Sets the costs of a candidate: the root mean square residual of both directions, each point
/// counted up to a cap; of the object without the share that may be none of the part, of the
/// reference only the share that any scan covers. To that comes what the surfaces cannot resolve:
/// without noise one pose is not many times as good as another because it was refined further.
void judge(const Surface& reference, const Surface& object, Density density, Candidate& candidate) {
  constexpr double kCap = 0.05;  // of the object's size
  constexpr double kObjectShare = 0.9;
  constexpr double kBulkShare = 0.75;
  constexpr double kReferenceShare = 0.5;
  const double cap = kCap * object.size;
  const Similarity& similarity = candidate.similarity;
  const Mapping mapping{similarity, {}};
  const auto capped_square = [cap](double distance) {
    return std::pow(std::min(distance, cap), 2);
  };
  std::vector<double> forth;
  for (const Residual& residual :
       residuals_of(reference, mapping, select(object.points, object.samples.of(density)))) {
    forth.push_back(
        capped_square(similarity.scale * std::hypot(residual.along_normal, residual.beside)));
  }
  std::vector<double> back;
  for (const std::size_t i : reference.samples.of(density)) {
    const double squared = object.tree->nearest(similarity * reference.points[i]).squared_distance;
    back.push_back(capped_square(std::max(0.0, std::sqrt(squared) - object.spacing)));
  }
  const double of_reference = mean_of_least(back, kReferenceShare);
  const double unresolved = std::pow(resolution(reference, object, similarity.scale), 2);
  candidate.cost = std::sqrt((mean_of_least(forth, kObjectShare) + of_reference) / 2 + unresolved);
  candidate.bulk_cost =
      std::sqrt((mean_of_least(forth, kBulkShare) + of_reference) / 2 + unresolved);
}

/// Candidates that cost many times what the best does will not win.
constexpr double kHopeless = 3;

void drop_hopeless(std::vector<Candidate>& candidates,
                   double best = std::numeric_limits<double>::infinity()) {
  for (const Candidate& each : candidates)
    best = std::min(best, each.bulk_cost);
  candidates.erase(
      std::remove_if(candidates.begin(), candidates.end(),
                     [&](const Candidate& each) { return !(each.bulk_cost <= kHopeless * best); }),
      candidates.end());
}

/// The search over all poses, in stages of which each keeps the better candidates.
class Search {
 public:
  Search(const Surface& reference, const Surface& object, const Prior& prior)
      : reference_(reference),
        object_(object),
        prior_(prior),
        coarse_reference_(coarsen(reference)),
        coarse_object_(coarsen(object)) {}

  /// Tries more poses coarsely; the distinct ones among all stay.
  void try_coarsely(const std::vector<Similarity>& guesses) {
    constexpr int kFirstIterations = 4;
    constexpr int kMoreIterations = 10;
    const ScaleRange scales = prior_.scale.range();
    std::vector<Candidate> tried;
    for (const Similarity& guess : allowed(guesses)) {
      tried.push_back(
          improve_coarsely(coarse_reference_, coarse_object_, guess, scales, kFirstIterations));
    }
    drop_hopeless(tried);
    tried = distinct(std::move(tried), probes(), 0.1 * object_.size, most_coarse_);
    for (Candidate& each : tried) {
      each = improve_coarsely(coarse_reference_, coarse_object_, each.similarity, scales,
                              kMoreIterations);
    }
    for (const Candidate& each : distinct(tried, probes(), 0.05 * object_.size, most_tried_))
      untried_.push_back(each);
  }

  /// Takes poses that were improved already.
  void take(const std::vector<PartialFit>& fits) {
    for (const PartialFit& fit : fits)
      untried_.push_back({fit.similarity, fit.agreement.cost, fit.agreement.cost});
  }

  /// Tries the best pose turned in itself, where that is not hopeless from the start. Of a part
  /// that is explained already all are kept that explain it as well: there may be many.
  void try_turned() {
    constexpr double kTurnedHopeless = 5;  // even rotations are up to 10 degrees off
    const Similarity best = candidates_.front().similarity;
    if (settled()) {
      most_coarse_ = 150;  // those that are only half refined yet are among them
      most_tried_ = 50;
      most_kept_ = 24;   // as many as a cube has
      refined_.clear();  // of those only few were kept
    }
    std::vector<Similarity> promising;
    const double cost = cost_as_it_is(best);
    for (const Similarity& turned : turned_in_itself(coarse_reference_.frame, best)) {
      if (cost_as_it_is(turned) < kTurnedHopeless * cost) promising.push_back(turned);
    }
    try_coarsely(promising);
  }

  /// Takes the best pose turned about an axis that it is nearly round about, and the best of those
  /// that were turned over.
  void try_turned_to_marks() {
    const Similarity best = candidates_.front().similarity;
    std::vector<Similarity> starts = {best};
    for (const Axis& axis : freest_axes(reference_, object_, best)) {
      const Eigen::Vector3d in_reference = best.rotation.transpose() * axis.along;
      const auto over =
          std::find_if(candidates_.begin(), candidates_.end(), [&](const Candidate& each) {
            constexpr double kOver = -0.9;  // cosine
            return (each.similarity.rotation * in_reference).dot(axis.along) < kOver;
          });
      if (over != candidates_.end()) starts.push_back(over->similarity);
    }
    for (const Similarity& start : starts) {
      for (const Similarity& turned : turned_to_marks(reference_, object_, start)) {
        Candidate candidate{turned, 0, 0};
        judge(reference_, object_, Density::kSome, candidate);
        candidates_.push_back(candidate);
      }
    }
  }

  /// Refines what was tried coarsely since the last time, and did not lead to a known pose.
  void refine_tried() {
    constexpr int kFirstIterations = 5;
    constexpr int kMoreIterations = 15;
    untried_ = new_ones(std::move(untried_), refined_, 0.05 * object_.size, most_tried_);
    for (const Candidate& each : untried_)
      refined_.push_back(each.similarity);
    improve(untried_, Density::kFewest, kFirstIterations);
    drop_hopeless(untried_);
    std::vector<Similarity> known;
    for (const Candidate& each : candidates_)
      known.push_back(each.similarity);
    untried_ = new_ones(std::move(untried_), known, 0.02 * object_.size, most_tried_);
    improve(untried_, Density::kFew, kFirstIterations);
    drop_hopeless(untried_, candidates_.empty() ? std::numeric_limits<double>::infinity()
                                                : candidates_.front().bulk_cost);
    improve(untried_, Density::kFew, kMoreIterations);
    for (const Candidate& each : untried_)
      candidates_.push_back(each);
    untried_.clear();
    candidates_ = distinct(std::move(candidates_), probes(), 0.03 * object_.size, most_kept_);
  }

  /// Whether the best pose leaves nothing to explain, as it is or slightly deformed: most of the
  /// object lies on the reference, and most of the reference was found again.
  bool settled() const {
    constexpr int kLevel = 2;
    if (candidates_.empty()) return false;
    const Similarity& best = candidates_.front().similarity;
    return explains_most({best, {}}) ||
           explains_most(sketch_deformation(reference_, object_, best, prior_.scale, kLevel));
  }

  void finish() {
    constexpr int kIterations = 30;
    drop_hopeless(candidates_);
    improve(candidates_, Density::kSome, kIterations);
    candidates_ = distinct(std::move(candidates_), probes(), 0.01 * object_.size, most_kept_);
  }

  const CoarseSurface& reference() const { return coarse_reference_; }
  const CoarseSurface& object() const { return coarse_object_; }
  const std::vector<Candidate>& candidates() const { return candidates_; }

 private:
  /// The best `most` that differ by more than `least_distance` [m] from each other and from those
  /// that are known.
  std::vector<Candidate> new_ones(std::vector<Candidate> candidates,
                                  const std::vector<Similarity>& known, double least_distance,
                                  std::size_t most) const {
    const auto is_known = [&](const Candidate& candidate) {
      return std::any_of(known.begin(), known.end(), [&](const Similarity& other) {
        return distance(candidate.similarity, other, probes()) < least_distance;
      });
    };
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_known),
                     candidates.end());
    return distinct(std::move(candidates), probes(), least_distance, most);
  }

  bool explains_most(const Mapping& mapping) const {
    constexpr double kReach = 0.4;  // spacings
    const Explanation explanation = explain(reference_, object_, mapping, kReach * object_.spacing);
    const auto reaches = [&explanation](double explained, double covered) {
      return explanation.inlier_ratio > explained && explanation.overlap > covered;
    };
    constexpr double kExplained = 0.88;
    constexpr double kCovered = 0.8;
    constexpr double kExplainedBesideOthers = 0.75;  // floor and loose points are in the scan, too
    constexpr double kWhollyCovered = 0.95;
    return reaches(kExplained, kCovered) || reaches(kExplainedBesideOthers, kWhollyCovered);
  }

  const Points& probes() const { return coarse_reference_.queries; }

  double cost_as_it_is(const Similarity& similarity) const {
    return improve_coarsely(coarse_reference_, coarse_object_, similarity, prior_.scale.range(), 0)
        .cost;
  }

  void improve(std::vector<Candidate>& candidates, Density density, int iterations) const {
    for (Candidate& each : candidates) {
      each.similarity =
          refine(reference_, object_, each.similarity, prior_.scale, density, iterations);
      judge(reference_, object_, density, each);
    }
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [this](const Candidate& each) {
                                      return !prior_.allows(each.similarity, middle());
                                    }),
                     candidates.end());
  }

  /// The guesses that may lead to a pose that the prior allows.
  std::vector<Similarity> allowed(const std::vector<Similarity>& guesses) const {
    constexpr double kAngle = 0.5;     // [rad] that the search may turn a guess
    constexpr double kDistance = 0.5;  // of the object's size that it may move one
    const Prior wide = prior_.widened(kAngle, kDistance * object_.size);
    std::vector<Similarity> result;
    for (const Similarity& guess : guesses) {
      const Similarity sized = clamped(guess, prior_.scale.range(), middle());
      if (wide.allows(sized, middle())) result.push_back(sized);
    }
    return result;
  }

  const Eigen::Vector3d& middle() const { return coarse_reference_.frame.centroid; }

  const Surface& reference_;
  const Surface& object_;
  const Prior& prior_;
  std::size_t most_coarse_ = 40;
  std::size_t most_tried_ = 12;
  std::size_t most_kept_ = 5;
  CoarseSurface coarse_reference_;
  CoarseSurface coarse_object_;
  std::vector<Candidate> untried_;
  std::vector<Similarity> refined_;  // as they were before
  std::vector<Candidate> candidates_;
};

}  // namespace

std::vector<Candidate> find_candidates(const Surface& reference, const Surface& object,
                                       const Prior& prior, PartialSearch& partial,
                                       const AlignmentProgress& progress) {
  Search search(reference, object, prior);
  if (prior.pose) {
    search.try_coarsely(guesses_about(prior, search.reference().frame, search.object().frame));
    search.refine_tried();
  }
  if (!search.settled()) {
    search.try_coarsely(principal_guesses(search.reference().frame, search.object().frame));
    search.refine_tried();
  }
  progress(0.3);
  if (!search.settled()) {
    search.take(partial.fits());
    progress(0.5);
    if (!partial.is_certain())
      search.try_coarsely(even_guesses(search.reference().frame, search.object().frame));
    search.refine_tried();
  }
  progress(0.7);
  if (search.candidates().empty()) return {};
  search.try_turned();
  search.refine_tried();
  progress(0.85);
  search.try_turned_to_marks();
  search.finish();
  progress(1);
  return search.candidates();
}

std::vector<Candidate> find_near_candidates(const Surface& reference, const Surface& object,
                                            const ScalePrior& scale) {
  const Prior prior{scale, {}};
  Search search(reference, object, prior);
  search.try_coarsely(principal_guesses(search.reference().frame, search.object().frame));
  search.refine_tried();
  if (search.candidates().empty()) return {};
  search.try_turned();
  search.refine_tried();
  search.finish();
  return search.candidates();
}

std::vector<Candidate> find_candidates(const Surface& reference, const Surface& object,
                                       const Prior& prior, const AlignmentProgress& progress) {
  PartialSearch partial(reference, object, prior);
  return find_candidates(reference, object, prior, partial, progress);
}

}  // namespace tool_path_stretcher
