// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "adaptation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "alignment/refinement.h"
#include "alignment/seeable_overlap.h"
#include "cores/by_index.h"
#include "geometry/points.h"
#include "placement/air.h"
#include "placement/expected_error.h"
#include "scan_cell_common/errors/errors.h"
#include "search/scale_search.h"
#include "thesis/thesis_fit.h"
#include "verdict/ambiguity.h"
#include "verdict/checks.h"
#include "verdict/handedness.h"
#include "verdict/partial_verdict.h"
#include "verdict/placement_checks.h"
#include "verdict/ranking.h"

namespace tool_path_stretcher {
namespace {

void tell(const Surface& reference, const Fitted& fitted, StretchResult& result) {
  result.aligned = true;
  result.similarity = fitted.mapping.similarity;
  result.mapped_reference = select(reference.points, reference.samples.many);
  for (Eigen::Vector3d& point : result.mapped_reference)
    point = fitted.mapping * point;
  result.deformation_nodes = fitted.mapping.graph.nodes().size();
  result.rms = fitted.explanation.rms;
  result.inlier_ratio = fitted.explanation.inlier_ratio;
  result.overlap = fitted.explanation.overlap;
}

ToolPath waypoints_of(const ToolPath& path, double spacing) {
  if (spacing == 0) return path;
  try {
    return resampled(path, spacing);
  } catch (const scan_cell_common::UnusableInput& error) {
    throw Refusal{{Reason::kUnusableInput, error.what(), {}}};
  }
}

std::string accepted_message(const Fitted& fitted, bool partial_reference, bool in_other_poses) {
  std::string message = kAdapted;
  if (partial_reference) {
    message +=
        fmt::format("; the reference shows only a part of the object, about {} % of its scan",
                    std::lround(100 * fitted.explanation.inlier_ratio));
  }
  if (in_other_poses) {
    message +=
        "; the object fits in another pose as well, with the path on the same line: it may start "
        "elsewhere on that line";
  }
  return message;
}

/// The part of an accepted path that is not based on the scan; empty if there is none.
std::string in_air_message(const std::vector<WaypointQuality>& quality) {
  const auto in_air = std::count_if(quality.begin(), quality.end(),
                                    [](const WaypointQuality& each) { return each.in_air; });
  if (in_air == 0) return "";
  return fmt::format("; {} of {} waypoints are in the air, carried along by the mapping", in_air,
                     quality.size());
}

/// Whether the part is bent, or a bend may be why some of it is not explained.
bool may_be_bent(const Fitted& fitted) {
  constexpr double kAll = 0.98;  // of the object's points; chosen
  if (explains_all(fitted.explanation)) return false;
  return !fitted.mapping.graph.empty() || fitted.explanation.inlier_ratio < kAll;
}

/// Of those clearly better than `best`, the one with the most evidence; null if there is none.
const Fitted* clearly_best(const std::vector<Fitted>& others, const Fitted& best) {
  const Fitted* found = nullptr;
  double most = 0;
  for (const Fitted& each : others) {
    if (!clearly_better(each.explanation, best.explanation)) continue;
    const Evidence speaks = evidence(each.explanation, best.explanation);
    const double lead = speaks.only_first - speaks.only_second;
    if (lead <= most) continue;
    most = lead;
    found = &each;
  }
  return found;
}

MappingError error_of(const SurfacePair& surfaces, const Mapping& mapping, const Prior& prior) {
  try {
    return {surfaces, mapping, prior};
  } catch (const UnheldMapping& error) {
    refuse(Reason::kPositionUncertain, "adapted path",
           std::string("its expected error cannot be computed: ") + error.what(),
           "scan more of the part, or give the scale or the initial pose");
  }
}

}  // namespace

Adaptation::Adaptation(const SurfacePair& surfaces, const ToolPath& path,
                       const StretchParameters& parameters, const Stages& stages)
    : surfaces_(surfaces),
      path_(waypoints_of(path, parameters.resample_spacing)),
      parameters_(parameters),
      stages_(stages),
      centroid_(surfaces.reference.centroid),
      partial_(surfaces, parameters.prior) {}

void Adaptation::run(Attempt& attempt) {
  StretchResult& result = attempt.result;
  attempt.candidates = search();
  std::vector<Fitted> fitted = choose(attempt.candidates);
  if (is_thesis(parameters_.method)) put_registration_first(fitted);
  count_what_could_be_seen(fitted.front());
  tell(surfaces_.reference, fitted.front(), result);
  bool partial_reference = false;
  if (!is_thesis(parameters_.method) &&
      fitted.front().explanation.inlier_ratio < parameters_.min_inlier_ratio) {
    if (const auto pose = pose_of_partial_reference(path_, surfaces_, partial_, parameters_)) {
      fitted = {explained({*pose, {}})};
      partial_reference = true;
    }
  }
  const std::vector<Fitted> slid = slide_on(fitted.front());
  attempt.fitted = fitted;
  tell(surfaces_.reference, fitted.front(), result);
  result.verdict.candidates = check_choice(fitted, slid, partial_reference);
  if (lays_only()) return;
  result.verdict.message =
      accepted_message(fitted.front(), partial_reference, !result.verdict.candidates.empty());
  Mapping mapping = fitted.front().mapping;
  if (parameters_.method == Method::kAffine) {
    mapping = affine_mapping(mapping.similarity);
    tell(surfaces_.reference, explained(mapping), result);
  }
  adapt(mapping, result);
}

void Adaptation::count_what_could_be_seen(Fitted& fitted) const {
  const bool is_tried_from_each_side = surfaces_.reference.closed || surfaces_.reference.whole;
  double& overlap = fitted.explanation.overlap;
  if (is_tried_from_each_side || overlap >= parameters_.min_overlap) return;
  overlap = seeable_overlap(surfaces_, fitted.mapping, parameters_.inlier_distance);
}

Fitted Adaptation::explained(const Mapping& mapping) const {
  return fitted(surfaces_, mapping, parameters_.inlier_distance);
}

std::vector<Candidate> Adaptation::search() {
  const Prior& prior = parameters_.prior;
  std::vector<Candidate> candidates =
      find_candidates(surfaces_, prior, partial_, stages_.within("align", 0.05, 0.5));
  if (candidates.empty()) {
    refuse_wrong_part(prior.pose || prior.scale.is_known()
                          ? "no pose of the reference fits it within the limits of the given "
                            "scale and initial pose"
                          : "no pose of the reference fits the object at all");
  }
  return candidates;
}

std::vector<Fitted> Adaptation::choose(const std::vector<Candidate>& candidates) const {
  const Prior& prior = parameters_.prior;
  std::vector<Fitted> fitted = sketched(candidates);
  drop_doubles(surfaces_.reference, fitted);
  keep_few(path_, parameters_.ambiguity_distance, fitted);
  deform(fitted);
  if (prior.pose) prefer_given_pose(*prior.pose, centroid_, fitted);
  return fitted;
}

void Adaptation::put_registration_first(std::vector<Fitted>& fitted) const {
  const Similarity registration =
      register_as_thesis(surfaces_, parameters_, stages_.within("register", 0.7, 0.9));
  if (!parameters_.prior.allows(registration, centroid_)) {
    refuse_wrong_part(
        "the registration ended outside the limits of the initial pose or the known scale");
  }
  const Fitted registered = explained({registration, {}});
  check_registration(surfaces_, registered, fitted);
  fitted.insert(fitted.begin(), registered);
}

std::vector<Fitted> Adaptation::sketched(const std::vector<Candidate>& candidates) const {
  constexpr double kHopeless = 5;  // times the cost of the best; chosen
  constexpr int kCoarse = 1;       // level of the graph
  std::vector<Similarity> hopeful;
  for (const Candidate& candidate : candidates) {
    if (candidate.bulk_cost <= kHopeless * candidates.front().bulk_cost)
      hopeful.push_back(candidate.similarity);
  }
  Parts parts(stages_, "refine", 0.5, 0.6, hopeful.size());
  auto result = by_index<Fitted>(hopeful.size(), kSingly, [&](std::size_t i) {
    Fitted sketch = explained(sketch_deformation(surfaces_, hopeful[i], parameters_.prior.scale,
                                                 std::min(kCoarse, parameters_.deformation_level)));
    parts.one_done();
    return sketch;
  });
  sort_best_first(result);
  return result;
}

void Adaptation::deform(std::vector<Fitted>& fitted) const {
  constexpr int kIterations = 30;  // at most; chosen
  const ScalePrior& scale = parameters_.prior.scale;
  Parts parts(stages_, "refine", 0.6, 0.7, fitted.size());
  for_indices(fitted.size(), kSingly, [&](std::size_t i) {
    Similarity start = fitted[i].mapping.similarity;
    if (fitted[i].mapping.graph.empty())
      start = refine(surfaces_, start, scale, Density::kMany, kIterations);
    fitted[i] = explained(fit_deformation(surfaces_, start, scale, parameters_.deformation_level));
    parts.one_done();
  });
  sort_best_first(fitted);
}

std::vector<Fitted> Adaptation::allowed(const std::vector<Mapping>& mappings) const {
  std::vector<Fitted> result;
  for (const Mapping& each : mappings) {
    if (parameters_.prior.allows(each.similarity, centroid_)) result.push_back(explained(each));
  }
  return result;
}

std::vector<Fitted> Adaptation::slide_on(Fitted& best) const {
  constexpr int kMost = 4;    // times; chosen
  constexpr int kCoarse = 1;  // level of the graph
  const ScalePrior& scale = parameters_.prior.scale;
  const int level = parameters_.deformation_level;
  std::vector<Fitted> slid;
  for (int i = 0; i < kMost; ++i) {
    slid.clear();
    if (best.explanation.inlier_ratio < parameters_.min_inlier_ratio) break;
    slid = allowed(slid_along_itself(surfaces_, best.mapping, scale));
    if (is_thesis(parameters_.method)) break;
    const Fitted* better = clearly_best(slid, best);
    std::vector<Fitted> bent;
    if (better == nullptr && may_be_bent(best)) {
      bent = allowed(slid_and_bent(surfaces_, best.mapping, scale, std::min(kCoarse, level)));
      better = clearly_best(bent, best);
    }
    if (better != nullptr) {
      Fitted next = explained(fit_deformation(surfaces_, better->mapping.similarity, scale, level));
      if (clearly_better(next.explanation, best.explanation)) {
        best = std::move(next);
        continue;
      }
    }
    for (Fitted& each : bent) {
      if (!same_path(path_, best.mapping, each.mapping, parameters_.max_position_error))
        slid.push_back(std::move(each));
    }
    break;
  }
  return slid;
}

std::vector<PoseCandidate> Adaptation::check_choice(const std::vector<Fitted>& fitted,
                                                    const std::vector<Fitted>& slid,
                                                    bool partial_reference) {
  constexpr double kWhole = 0.95;  // of either surface's points; chosen
  const Fitted& best = fitted.front();
  check_handedness(surfaces_, best, parameters_);
  if (!partial_reference) check_explained(best.explanation, parameters_);
  check_overlap(best, parameters_);
  check_deformation(surfaces_.reference, best.mapping, parameters_);
  std::vector<PoseCandidate> alike;
  const auto add_if_alike = [&](const Fitted& other) {
    if (check_unambiguous(path_, surfaces_, best, other, parameters_))
      alike.push_back(candidate_of(path_, other.mapping));
  };
  std::for_each(fitted.begin() + 1, fitted.end(), add_if_alike);
  std::for_each(slid.begin(), slid.end(), add_if_alike);
  if (!lays_only() && std::min(best.explanation.overlap, best.explanation.inlier_ratio) < kWhole)
    check_rivals(path_, surfaces_, best.mapping, partial_, parameters_);
  if (!alike.empty()) alike.insert(alike.begin(), candidate_of(path_, best.mapping));
  return alike;
}

Mapping Adaptation::affine_mapping(const Similarity& start) const {
  const ScalePrior& known = parameters_.prior.scale;
  if (known.is_fixed()) return {start, {}};
  const double scale = known.is_known() ? known.value : principal_scale(surfaces_);
  const ScaleSearch search =
      search_scale(surfaces_, start, scale, parameters_.scale_range, parameters_.scale_steps,
                   parameters_.inlier_distance, stages_.within("scale search", 0.7, 0.9));
  if (search.at_bound) refuse_search_at_bound(search.best.scale, parameters_);
  return {search.best, {}};
}

void Adaptation::adapt(const Mapping& mapping, StretchResult& result) const {
  stages_.report("adapt", 0.9);
  result.reference_path = path_;
  const double spacing =
      mapping.similarity.scale * surfaces_.reference.spacing + surfaces_.object.spacing;
  const MappingError mapping_error = error_of(surfaces_, mapping, parameters_.prior);
  Placement placement = place(
      path_, surfaces_, mapping, mapping_error,
      {parameters_.support_radius, parameters_.min_support, max_stranger(parameters_, spacing),
       distances_of(path_, surfaces_.reference, parameters_).in_air,
       parameters_.method == Method::kGeneral, parameters_.stand_off == StandOff::kKeep});
  const bool nearest_points = parameters_.method == Method::kThesisGeneral;
  if (nearest_points) move_to_nearest_points(path_, surfaces_, mapping, placement);
  expect_errors(path_, mapping_error, placement);
  if (nearest_points) expect_sampling_errors(surfaces_.object.spacing, placement);
  result.quality = placement.quality;
  check_fold_over(path_, placement.path, surfaces_, mapping);
  check_placement(placement,
                  {spacing, mapping.similarity.scale * length_of(surfaces_.reference),
                   surfaces_.reference.oriented},
                  parameters_);
  result.verdict.message += in_air_message(placement.quality);
  stages_.report("done", 1);
  result.path = std::move(placement.path);
}

}  // namespace tool_path_stretcher
