// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>

#include "alignment/coarse_fit.h"
#include "alignment/refinement.h"
#include "cores/by_index.h"
#include "search/candidates.h"
#include "search/guesses.h"
#include "search/search_engine.h"

namespace tool_path_stretcher {
namespace {

std::vector<Similarity> poses_of(const std::vector<Candidate>& candidates) {
  std::vector<Similarity> poses;
  for (const Candidate& each : candidates)
    poses.push_back(each.similarity);
  return poses;
}

void append(const std::vector<Candidate>& more, std::vector<Candidate>& candidates) {
  candidates.insert(candidates.end(), more.begin(), more.end());
}

class WholeSearch {
 public:
  /// @param bulk_cost [m] of a pose of something else that explains the object
  WholeSearch(const SurfacePair& surfaces, const Prior& prior, double bulk_cost = kNever)
      : surfaces_(surfaces),
        prior_(prior),
        bulk_cost_(bulk_cost),
        coarse_(surfaces),
        engine_(coarse_.reference.queries, surfaces.object.size,
                [this](const Round& round, Candidate& each) { return improve(round, each); }) {}

  /// Tries more poses coarsely, and keeps the distinct ones among all.
  void try_coarsely(const std::vector<Similarity>& guesses) {
    std::vector<Candidate> tried;
    for (const Similarity& guess : allowed(guesses))
      tried.push_back({guess});
    engine_.run(rounds_.guess, tried);
    engine_.run(rounds_.near, tried);
    append(tried, untried_);
  }

  /// Adds poses that are already improved.
  void take(const std::vector<Candidate>& candidates) {
    for (const Candidate& each : candidates)
      untried_.push_back({each.similarity, each.cost, each.cost});
  }

  /// Tries the best pose rotated within itself, unless that is hopeless from the start. If the part
  /// is already explained, keeps all that explain it as well.
  void try_turned() {
    constexpr double kHopeless = 5;  // times the cost: even rotations are up to 10 degrees off
    const Similarity best = candidates_.front().similarity;
    if (settled()) {
      rounds_ = kTurnedRounds;
      refined_.clear();  // only a few of those were kept
    }
    std::vector<Similarity> promising;
    const double cost = cost_as_it_is(best);
    const std::vector<Similarity> turned = turned_in_itself(coarse_.reference.frame, best);
    const auto costs = by_index<double>(turned.size(), kDozens,
                                        [&](std::size_t i) { return cost_as_it_is(turned[i]); });
    for (std::size_t i = 0; i < turned.size(); ++i) {
      if (costs[i] < kHopeless * cost) promising.push_back(turned[i]);
    }
    try_coarsely(promising);
  }

  /// Adds the best pose, and the best one of those turned over, rotated about an axis about which
  /// it is nearly round.
  void try_turned_to_marks() {
    const Similarity best = candidates_.front().similarity;
    std::vector<Similarity> starts = {best};
    for (const Axis& axis : freest_axes(surfaces_, best)) {
      const Eigen::Vector3d in_reference = best.rotation.transpose() * axis.along;
      const auto over =
          std::find_if(candidates_.begin(), candidates_.end(), [&](const Candidate& each) {
            constexpr double kOver = -0.9;  // cosine: rotated by more than 154 degrees; chosen
            return (each.similarity.rotation * in_reference).dot(axis.along) < kOver;
          });
      if (over != candidates_.end()) starts.push_back(over->similarity);
    }
    std::vector<Similarity> turned;
    for (const Similarity& start : starts) {
      const std::vector<Similarity> more = turned_to_marks(surfaces_, start);
      turned.insert(turned.end(), more.begin(), more.end());
    }
    append(by_index<Candidate>(turned.size(), kSingly,
                               [&](std::size_t i) {
                                 return judged(surfaces_, {turned[i], {}}, Density::kSome);
                               }),
           candidates_);
  }

  /// Refines the poses tried coarsely since the last call that do not lead to a known pose.
  void refine_tried() {
    engine_.select(rounds_.near, untried_, {refined_});
    for (const Candidate& each : untried_)
      refined_.push_back(each.similarity);
    engine_.run(rounds_.retry, untried_, {poses_of(candidates_)});
    engine_.run(rounds_.rough, untried_,
                {{}, candidates_.empty() ? kNever : least_known(candidates_.front())});
    engine_.improve(rounds_.fine, untried_);
    append(untried_, candidates_);
    untried_.clear();
    engine_.select(rounds_.fine, candidates_);
  }

  /// Whether the best pose, undeformed or slightly deformed, leaves nothing to explain: most of the
  /// object lies on the reference, and most of the reference was found.
  bool settled() {
    constexpr int kLevel = 2;  // of the deformation graph, of 3; chosen
    if (candidates_.empty()) return false;
    const Similarity& best = candidates_.front().similarity;
    if (!settling_ || settling_->pose.matrix() != best.matrix()) {
      settling_ = Settling{
          best, explains_most({best, {}}) ||
                    explains_most(sketch_deformation(surfaces_, best, prior_.scale, kLevel))};
    }
    return settling_->settled;
  }

  void finish() {
    if (candidates_.empty()) return;
    engine_.select(rounds_.rough, candidates_,  // drops the hopeless
                   {{}, least_known(candidates_.front())});
    engine_.run(rounds_.last, candidates_);
  }

  const CoarsePair& coarse() const { return coarse_; }
  const std::vector<Candidate>& candidates() const { return candidates_; }

 private:
  double least_known(const Candidate& best) const { return std::min(best.bulk_cost, bulk_cost_); }

  struct Settling {
    Similarity pose;
    bool settled;
  };

  bool improve(const Round& round, Candidate& each) const {
    if (!round.density) {
      each = improve_coarsely(coarse_, each.similarity, prior_.scale.range(), round.iterations);
      return true;
    }
    const Similarity refined =
        refine(surfaces_, each.similarity, prior_.scale, *round.density, round.iterations);
    each = judged(surfaces_, {refined, {}}, *round.density);
    return prior_.allows(each.similarity, middle());
  }

  bool explains_most(const Mapping& mapping) const {
    constexpr double kReach = 0.4;       // of the object's spacing; chosen
    constexpr double kExplained = 0.88;  // of the object's points; chosen, as all shares here
    constexpr double kCovered = 0.8;     // of the reference's points
    constexpr double kExplainedBesideOthers = 0.75;  // the scan includes floor and loose points
    constexpr double kWhollyCovered = 0.95;
    const Explanation found = explain(surfaces_, mapping, kReach * surfaces_.object.spacing);
    const auto reaches = [&found](double explained, double covered) {
      return found.inlier_ratio > explained && found.overlap > covered;
    };
    return reaches(kExplained, kCovered) || reaches(kExplainedBesideOthers, kWhollyCovered);
  }

  double cost_as_it_is(const Similarity& similarity) const {
    return improve_coarsely(coarse_, similarity, prior_.scale.range(), 0).cost;
  }

  /// The guesses that may lead to a pose that the prior allows.
  std::vector<Similarity> allowed(const std::vector<Similarity>& guesses) const {
    constexpr double kAngle = 0.5;     // [rad] by which the search may rotate a guess; chosen
    constexpr double kDistance = 0.5;  // of the object's size: may move a guess; chosen
    const Prior wide = prior_.widened(kAngle, kDistance * surfaces_.object.size);
    std::vector<Similarity> result;
    for (const Similarity& guess : guesses) {
      const Similarity sized = clamped(guess, prior_.scale.range(), middle());
      if (wide.allows(sized, middle())) result.push_back(sized);
    }
    return result;
  }

  const Eigen::Vector3d& middle() const { return coarse_.reference.frame.centroid; }

  const SurfacePair surfaces_;
  const Prior& prior_;
  const double bulk_cost_;
  const CoarsePair coarse_;
  SearchEngine engine_;
  WholeRounds rounds_ = kWholeRounds;
  std::vector<Candidate> untried_;
  std::vector<Similarity> refined_;  // as before refinement
  std::vector<Candidate> candidates_;
  std::optional<Settling> settling_;  // of the best pose at the last call
};

}  // namespace

std::vector<Candidate> find_candidates(const SurfacePair& surfaces, const Prior& prior,
                                       PartialSearch& partial, const AlignmentProgress& progress) {
  WholeSearch search(surfaces, prior);
  if (prior.pose) {
    search.try_coarsely(guesses_about(prior, search.coarse()));
    search.refine_tried();
  }
  if (!search.settled()) {
    search.try_coarsely(principal_guesses(search.coarse()));
    search.refine_tried();
  }
  progress(0.3);
  if (!search.settled()) {
    search.take(partial.fits());
    progress(0.5);
    if (!partial.is_certain()) search.try_coarsely(even_guesses(search.coarse()));
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

std::vector<Candidate> find_candidates(const SurfacePair& surfaces, const Prior& prior,
                                       const AlignmentProgress& progress) {
  PartialSearch partial(surfaces, prior);
  return find_candidates(surfaces, prior, partial, progress);
}

std::vector<Candidate> find_near_candidates(const SurfacePair& surfaces, const ScalePrior& scale,
                                            double bulk_cost) {
  const Prior prior{scale, {}};
  WholeSearch search(surfaces, prior, bulk_cost);
  search.try_coarsely(principal_guesses(search.coarse()));
  search.refine_tried();
  if (search.candidates().empty()) return {};
  search.try_turned();
  search.refine_tried();
  search.finish();
  return search.candidates();
}

}  // namespace tool_path_stretcher
