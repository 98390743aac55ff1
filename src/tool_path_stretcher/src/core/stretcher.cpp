// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/stretcher.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "alignment/refinement.h"
#include "cores/by_index.h"
#include "geometry/points.h"
#include "placement/air.h"
#include "placement/expected_error.h"
#include "scan_cell_common/errors/errors.h"
#include "scene/own_place.h"
#include "search/candidates.h"
#include "search/scale_search.h"
#include "sight/seeable.h"
#include "stages.h"
#include "thesis/thesis_fit.h"
#include "verdict/ambiguity.h"
#include "verdict/checks.h"
#include "verdict/handedness.h"
#include "verdict/partial_verdict.h"
#include "verdict/placement_checks.h"
#include "views/views.h"

namespace tool_path_stretcher {
namespace {

/// Mean square residual of both directions, each point counted up to what is noise, sampling or
/// grid at most, and as a share of that.
double capped_cost(const Explanation& explanation, double noise) {
  const auto mean = [noise](const Distances& distances) {
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < distances.off.size(); ++i) {
      if (std::isnan(distances.off[i])) continue;
      const double share = distances.off[i] / std::max(noise, distances.blur[i]);
      sum += std::min(share * share, 1.0);
      count += 1;
    }
    return count > 0 ? sum / count : 1;
  };
  return mean(explanation.object) + mean(explanation.reference);
}

void sort_best_first(std::vector<Fitted>& fitted) {
  constexpr double kDeviations = 3;  // standard: 0.3 % of normal noise
  double noise = fitted.front().explanation.noise;
  for (const Fitted& each : fitted)
    noise = std::min(noise, each.explanation.noise);
  std::vector<std::pair<double, std::size_t>> order;
  for (const Fitted& each : fitted)
    order.emplace_back(capped_cost(each.explanation, kDeviations * noise), order.size());
  std::sort(order.begin(), order.end());
  std::vector<Fitted> sorted;
  for (const auto& [cost, index] : order)
    sorted.push_back(std::move(fitted[index]));
  fitted = std::move(sorted);
}

/// Drops those that have come to where a better one is.
void drop_doubles(const Surface& reference, std::vector<Fitted>& fitted) {
  constexpr double kAlike = 0.01;  // of the size: as in the last round of the search
  const Points probes = select(reference.points, reference.samples.fewest);
  const auto is_double = [&](const Mapping& one, const Mapping& other) {
    return std::all_of(probes.begin(), probes.end(), [&](const Eigen::Vector3d& probe) {
      return (one * probe - other * probe).norm() < kAlike * one.similarity.scale * reference.size;
    });
  };
  std::vector<Fitted> kept;
  for (Fitted& each : fitted) {
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const Fitted& other) { return is_double(other.mapping, each.mapping); }))
      kept.push_back(std::move(each));
  }
  fitted = std::move(kept);
}

/// Keeps a few of those that explain the object about as well as the first does, so that the rest
/// of the work stays short: first those that lay the path elsewhere, since they decide.
void keep_few(const ToolPath& path, double tolerance, std::vector<Fitted>& fitted) {
  constexpr std::size_t kMost = 4;  // chosen
  const Explanation& best = fitted.front().explanation;
  fitted.erase(
      std::remove_if(fitted.begin() + 1, fitted.end(),
                     [&](const Fitted& each) { return clearly_better(best, each.explanation); }),
      fitted.end());
  if (fitted.size() <= kMost) return;
  const Mapping first = fitted.front().mapping;
  std::stable_partition(fitted.begin() + 1, fitted.end(), [&](const Fitted& each) {
    return !same_path(path, first, each.mapping, tolerance);
  });
  fitted.resize(kMost);
}

/// Puts the one that lies nearest to the given pose first, of those that explain the object as well
/// as the first does.
void prefer_given_pose(const PosePrior& given, const Eigen::Vector3d& middle,
                       std::vector<Fitted>& fitted) {
  const auto off = [&](const Fitted& each) {
    return (each.mapping * middle - given.pose * middle).norm();
  };
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < fitted.size(); ++i) {
    if (clearly_better(fitted.front().explanation, fitted[i].explanation)) continue;
    if (off(fitted[i]) < off(fitted[nearest])) nearest = i;
  }
  std::swap(fitted.front(), fitted[nearest]);
}

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

/// What an accepted path is not founded on the scan with; empty where that is nothing.
std::string in_air_message(const std::vector<WaypointQuality>& quality) {
  const auto in_air = std::count_if(quality.begin(), quality.end(),
                                    [](const WaypointQuality& each) { return each.in_air; });
  if (in_air == 0) return "";
  return fmt::format("; {} of {} waypoints are in the air, carried along by the mapping", in_air,
                     quality.size());
}

/// The work on one path.
class Adaptation {
 public:
  /// @throw Refusal if the path makes no sense
  Adaptation(const SurfacePair& surfaces, const ToolPath& path, const StretchParameters& parameters,
             const Stages& stages)
      : surfaces_(surfaces),
        path_(waypoints_of(path, parameters.resample_spacing)),
        parameters_(parameters),
        stages_(stages),
        centroid_(surfaces.reference.centroid),
        partial_(surfaces, parameters.prior) {}

  /// Fills in the result, and the mappings it chose from, as far as the work comes.
  /// @throw Refusal
  void run(StretchResult& result, std::vector<Fitted>& chosen_from) {
    std::vector<Fitted> fitted = choose();
    if (is_thesis(parameters_.method)) put_registration_first(fitted);
    chosen_from = fitted;
    tell(surfaces_.reference, fitted.front(), result);
    bool partial_reference = false;
    if (!is_thesis(parameters_.method) &&
        fitted.front().explanation.inlier_ratio < parameters_.min_inlier_ratio) {
      if (const auto pose = pose_of_partial_reference(path_, surfaces_, partial_, parameters_)) {
        fitted = {explained({*pose, {}})};
        partial_reference = true;
        tell(surfaces_.reference, fitted.front(), result);
      }
    }
    result.verdict.candidates = check_choice(fitted, partial_reference);
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

 private:
  /// There is no path: poses differ in nothing that matters.
  bool lays_only() const { return path_.segments.empty(); }

  Fitted explained(const Mapping& mapping) const {
    return fitted(surfaces_, mapping, parameters_.inlier_distance);
  }

  /// All mappings that may explain the object, best first.
  /// @throw Refusal if there is none
  std::vector<Fitted> choose() {
    const Prior& prior = parameters_.prior;
    const std::vector<Candidate> candidates =
        find_candidates(surfaces_, prior, partial_, stages_.within("align", 0.05, 0.5));
    if (candidates.empty()) {
      refuse_wrong_part(prior.pose || prior.scale.is_known()
                            ? "no pose of the reference fits it with the scale and the initial "
                              "pose given, as far as they may be off"
                            : "no pose of the reference fits the object at all");
    }
    std::vector<Fitted> fitted = sketched(candidates);
    drop_doubles(surfaces_.reference, fitted);
    keep_few(path_, parameters_.ambiguity_distance, fitted);
    deform(fitted);
    if (prior.pose) prefer_given_pose(*prior.pose, centroid_, fitted);
    return fitted;
  }

  /// What the thesis' registration finds, judged beside what the search found.
  /// @throw Refusal
  void put_registration_first(std::vector<Fitted>& fitted) const {
    const Similarity registration =
        register_as_thesis(surfaces_, parameters_, stages_.within("register", 0.7, 0.9));
    if (!parameters_.prior.allows(registration, centroid_)) {
      refuse_wrong_part(
          "the registration ended farther from the initial pose or the known scale "
          "than they may be off");
    }
    const Fitted registered = explained({registration, {}});
    check_registration(surfaces_, registered, fitted);
    fitted.insert(fitted.begin(), registered);
  }

  /// The candidates that may yet win with a coarse deformation graph, best first. A pose is judged
  /// with a graph: a bend must not decide between two poses that a small feature tells apart.
  std::vector<Fitted> sketched(const std::vector<Candidate>& candidates) const {
    constexpr double kHopeless = 5;  // times the cost of the best; chosen
    constexpr int kCoarse = 1;       // level of the graph
    std::vector<Similarity> hopeful;
    for (const Candidate& candidate : candidates) {
      if (candidate.bulk_cost <= kHopeless * candidates.front().bulk_cost)
        hopeful.push_back(candidate.similarity);
    }
    Parts parts(stages_, "refine", 0.5, 0.6, hopeful.size());
    auto result = by_index<Fitted>(hopeful.size(), kSingly, [&](std::size_t i) {
      Fitted sketch =
          explained(sketch_deformation(surfaces_, hopeful[i], parameters_.prior.scale,
                                       std::min(kCoarse, parameters_.deformation_level)));
      parts.one_done();
      return sketch;
    });
    sort_best_first(result);
    return result;
  }

  /// Fits the finest deformation graph, and sorts again.
  void deform(std::vector<Fitted>& fitted) const {
    constexpr int kIterations = 30;  // at most; chosen
    const ScalePrior& scale = parameters_.prior.scale;
    Parts parts(stages_, "refine", 0.6, 0.7, fitted.size());
    for_indices(fitted.size(), kSingly, [&](std::size_t i) {
      Similarity start = fitted[i].mapping.similarity;
      if (fitted[i].mapping.graph.empty())
        start = refine(surfaces_, start, scale, Density::kMany, kIterations);
      fitted[i] =
          explained(fit_deformation(surfaces_, start, scale, parameters_.deformation_level));
      parts.one_done();
    });
    sort_best_first(fitted);
  }

  /// @return the best and the others that explain the object as well, where those lay the path
  /// along the same line; nothing where there are none
  /// @throw Refusal if the best does not explain the object, or another one does, too
  std::vector<PoseCandidate> check_choice(const std::vector<Fitted>& fitted,
                                          bool partial_reference) {
    constexpr double kWhole = 0.95;  // of either surface's points; chosen
    const Fitted& best = fitted.front();
    if (!partial_reference) {
      check_handedness(surfaces_, best, parameters_);
      check_explained(best.explanation, parameters_);
    }
    check_overlap(best, parameters_);
    check_deformation(surfaces_.reference, best.mapping, parameters_);
    std::vector<PoseCandidate> alike;
    for (std::size_t i = 1; i < fitted.size(); ++i) {
      if (check_unambiguous(path_, surfaces_, best, fitted[i], parameters_))
        alike.push_back(candidate_of(path_, fitted[i].mapping));
    }
    for (const Mapping& slid :
         slid_along_itself(surfaces_, best.mapping, parameters_.prior.scale)) {
      if (!parameters_.prior.allows(slid.similarity, centroid_)) continue;
      if (check_unambiguous(path_, surfaces_, best, explained(slid), parameters_))
        alike.push_back(candidate_of(path_, slid));
    }
    if (!lays_only() && std::min(best.explanation.overlap, best.explanation.inlier_ratio) < kWhole)
      check_rivals(path_, surfaces_, best.mapping, partial_, parameters_);
    if (!alike.empty()) alike.insert(alike.begin(), candidate_of(path_, best.mapping));
    return alike;
  }

  Mapping affine_mapping(const Similarity& start) const {
    const ScalePrior& known = parameters_.prior.scale;
    if (known.is_fixed()) return {start, {}};
    const double scale = known.is_known() ? known.value : principal_scale(surfaces_);
    const ScaleSearch search =
        search_scale(surfaces_, start, scale, parameters_.scale_range, parameters_.scale_steps,
                     parameters_.inlier_distance, stages_.within("scale search", 0.7, 0.9));
    if (search.at_bound) refuse_search_at_bound(search.best.scale, parameters_);
    return {search.best, {}};
  }

  void adapt(const Mapping& mapping, StretchResult& result) const {
    stages_.report("adapt", 0.9);
    result.reference_path = path_;
    const double spacing =
        mapping.similarity.scale * surfaces_.reference.spacing + surfaces_.object.spacing;
    const MappingError mapping_error(surfaces_, mapping, parameters_.prior);
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
    check_placement(placement, {spacing, mapping.similarity.scale * length_of(surfaces_.reference)},
                    parameters_);
    result.verdict.message += in_air_message(placement.quality);
    stages_.report("done", 1);
    result.path = std::move(placement.path);
  }

  const SurfacePair surfaces_;
  const ToolPath path_;
  const StretchParameters& parameters_;
  const Stages& stages_;
  const Eigen::Vector3d centroid_;  // of the reference [m]
  PartialSearch partial_;
};

StretchResult begun(const Surface& reference, const Surface& object,
                    const StretchParameters& parameters) {
  StretchResult result;
  result.method = parameters.method;
  result.reference_points = reference.points.size();
  result.object_points = object.points.size();
  return result;
}

/// With all of the reference; with what can be seen of it where the prior has a view.
Attempt attempt(const SurfacePair& surfaces, const ToolPath& path,
                const StretchParameters& parameters, const Stages& stages) {
  const bool is_whole = !parameters.prior.view;
  Attempt attempt{is_whole, begun(surfaces.reference, surfaces.object, parameters), {}};
  try {
    stages.report("check", 0);
    check_surfaces(surfaces, parameters);
    const bool has_path = !path.segments.empty();
    if (has_path && is_whole) check_path(path, surfaces.reference, parameters);
    if (has_path && !is_whole) check_seeable(path, surfaces.reference, parameters);
    Adaptation adaptation(surfaces, path, parameters, stages);
    stages.report("align", 0.05);
    adaptation.run(attempt.result, attempt.fitted);
  } catch (const Refusal& refusal) {
    attempt.result.verdict = refusal.verdict;
  }
  return attempt;
}

/// No scan sees all of a closed reference, and both faces of a sheet of it would do for one.
StretchResult stretch_closed(const SurfacePair& surfaces, const ToolPath& path,
                             const StretchParameters& parameters, const Progress& progress) {
  constexpr double kFirst = 0.3;  // of the work; a guess for the bar
  std::vector<Attempt> attempts = {
      attempt(surfaces, path, parameters, Stages(progress, 0, kFirst))};
  const std::vector<ViewPrior> views = possible_views(surfaces, attempts.front().fitted);
  const double each = (1 - kFirst) / std::max(1.0, static_cast<double>(views.size()));
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (attempts.back().result.verdict.reason == Reason::kCancelled) return attempts.back().result;
    const Surface seeable = seeable_part(surfaces.reference, views[i].of_reference);
    if (seeable.points.size() < static_cast<std::size_t>(parameters.min_points)) continue;
    StretchParameters with_view = parameters;
    with_view.prior.view = views[i];
    const double from = kFirst + each * static_cast<double>(i);
    attempts.push_back(
        attempt({seeable, surfaces.object}, path, with_view, Stages(progress, from, from + each)));
  }
  return judge(attempts, path, surfaces, parameters);
}

StretchResult stretch_onto(const SurfacePair& surfaces, const ToolPath& path,
                           const StretchParameters& parameters, const Progress& progress) {
  return surfaces.reference.closed && !is_thesis(parameters.method)
             ? stretch_closed(surfaces, path, parameters, progress)
             : attempt(surfaces, path, parameters, Stages(progress)).result;
}

bool explains_too_little(const StretchResult& result, const StretchParameters& parameters) {
  return result.verdict.reason == Reason::kWrongPart && result.aligned &&
         result.inlier_ratio < parameters.min_inlier_ratio;
}

StretchResult stretch_in_scene(const SurfacePair& surfaces, const ToolPath& path,
                               const StretchParameters& parameters, const Progress& progress) {
  const StretchResult result = stretch_onto(surfaces, path, parameters, progress);
  if (!explains_too_little(result, parameters)) return result;
  const Progress still_at_work = [&progress](const std::string& stage, double) {
    constexpr double kLate = 0.9;  // of the work; a guess for the bar
    return !progress || progress(stage, kLate);
  };
  const auto onto = [&](const Surface& part) {
    return stretch_onto({surfaces.reference, part}, path, parameters, still_at_work);
  };
  return stretch_in_own_place(surfaces.object, path, result, parameters, onto);
}

/// @throw nothing: the verdict says what is wrong with it
StretchResult without_a_path(const ToolPath& path, StretchResult result) {
  try {
    check(path);
  } catch (const scan_cell_common::UnusableInput& error) {
    result.verdict = {Reason::kUnusableInput, error.what(), {}};
  }
  return result;
}

}  // namespace

StretchResult stretch(const Surface& reference, const Surface& object, const ToolPath& path,
                      const StretchParameters& parameters, const Progress& progress) {
  check(parameters);
  const auto start = std::chrono::steady_clock::now();
  StretchResult result = path.segments.empty()
                             ? without_a_path(path, begun(reference, object, parameters))
                             : stretch_in_scene({reference, object}, path, parameters, progress);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

StretchResult lay(const Surface& reference, const Surface& object,
                  const StretchParameters& parameters, const Progress& progress) {
  check(parameters);
  StretchParameters alone = parameters;
  alone.method = Method::kGeneral;
  alone.resample_spacing = 0;
  return stretch_in_scene({reference, object}, {}, alone, progress);
}

}  // namespace tool_path_stretcher
