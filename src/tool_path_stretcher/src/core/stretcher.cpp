// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/stretcher.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "geometry/robust.h"
#include "placement/expected_error.h"
#include "scan_cell_common/errors.h"
#include "search/alignment.h"
#include "verdict/ambiguity.h"
#include "verdict/checks.h"
#include "verdict/handedness.h"
#include "verdict/partial_verdict.h"

namespace tool_path_stretcher {
namespace {

/// A candidate after the deformation graph was fitted to it.
struct Fitted {
  Mapping mapping;
  Explanation explanation;
  bool of_partial_reference = false;  // it need not explain all of the object
};

/// Tells the caller how far the work is, and ends it where the caller wants that.
class Stages {
 public:
  explicit Stages(const Progress& progress) : progress_(progress) {}

  void report(const std::string& stage, double done) const {
    if (progress_ && !progress_(stage, done)) {
      throw Refusal{{Reason::kCancelled, "cancelled during '" + stage + "'", {}}};
    }
  }

  AlignmentProgress within(const std::string& stage, double from, double to) const {
    return [this, stage, from, to](double share) { report(stage, from + share * (to - from)); };
  }

 private:
  const Progress& progress_;
};

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
  constexpr double kDeviations = 3;
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

/// Of what explains the object about as well as the first does, so much that the rest of the work
/// stays short: first what lays the path elsewhere, since that decides.
void keep_few(const ToolPath& path, double tolerance, std::vector<Fitted>& fitted) {
  constexpr std::size_t kMost = 4;
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

/// Fits the deformation graph to the candidates that may yet win, best first: a coarse one to all,
/// the finest to those that it does not rule out. A pose is judged after it: a bend must not decide
/// between two poses that a small feature tells apart.
std::vector<Fitted> fit_all(const Surface& reference, const Surface& object, const ToolPath& path,
                            const std::vector<Candidate>& candidates,
                            const StretchParameters& parameters, const Stages& stages) {
  constexpr double kHopeless = 5;  // times the cost of the best
  constexpr int kCoarse = 1;
  constexpr int kIterations = 30;
  const ScalePrior& scale = parameters.prior.scale;
  const auto explained = [&](const Mapping& mapping) {
    return Fitted{mapping, explain(reference, object, mapping, parameters.inlier_distance), false};
  };
  std::vector<Fitted> fitted;
  for (const Candidate& candidate : candidates) {
    if (candidate.bulk_cost > kHopeless * candidates.front().bulk_cost) continue;
    fitted.push_back(
        explained(sketch_deformation(reference, object, candidate.similarity, scale,
                                     std::min(kCoarse, parameters.deformation_level))));
    stages.report("refine", 0.5 + 0.1 * static_cast<double>(fitted.size()) /
                                      static_cast<double>(candidates.size()));
  }
  sort_best_first(fitted);
  keep_few(path, parameters.ambiguity_distance, fitted);
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    Similarity start = fitted[i].mapping.similarity;
    if (fitted[i].mapping.graph.empty()) {
      start = refine(reference, object, start, scale, Density::kMany, kIterations);
    }
    fitted[i] =
        explained(fit_deformation(reference, object, start, scale, parameters.deformation_level));
    stages.report("refine",
                  0.6 + 0.1 * static_cast<double>(i + 1) / static_cast<double>(fitted.size()));
  }
  sort_best_first(fitted);
  return fitted;
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

Mapping affine_mapping(const Surface& reference, const Surface& object, const Similarity& start,
                       const StretchParameters& parameters, const Stages& stages) {
  const ScalePrior& known = parameters.prior.scale;
  if (known.is_fixed()) return {start, {}};
  const ScaleSearch search = search_scale(
      reference, object, start, known.is_known() ? known.value : principal_scale(reference, object),
      parameters.scale_range, parameters.scale_steps, parameters.inlier_distance,
      stages.within("scale search", 0.7, 0.9));
  if (search.at_bound) refuse_search_at_bound(search.best.scale, parameters);
  return {search.best, {}};
}

ToolPath waypoints_of(const ToolPath& path, double spacing) {
  if (spacing == 0) return path;
  try {
    return resampled(path, spacing);
  } catch (const scan_cell_common::UnusableInput& error) {
    throw Refusal{{Reason::kUnusableInput, error.what(), {}}};
  }
}

void tell(const Mapping& mapping, const Explanation& explanation, StretchResult& result) {
  result.aligned = true;
  result.similarity = mapping.similarity;
  result.deformation_nodes = mapping.graph.nodes().size();
  result.rms = explanation.rms;
  result.inlier_ratio = explanation.inlier_ratio;
  result.overlap = explanation.overlap;
}

/// Where the best of all poses does not explain the object: the pose of a reference that shows only
/// a part of it, if there is one.
std::optional<Fitted> partial_reference(const Surface& reference, const Surface& object,
                                        const ToolPath& path, PartialSearch& search,
                                        const StretchParameters& parameters) {
  const std::optional<Similarity> pose =
      pose_of_partial_reference(path, reference, object, search, parameters);
  if (!pose) return {};
  const Mapping mapping{*pose, {}};
  return Fitted{mapping, explain(reference, object, mapping, parameters.inlier_distance), true};
}

std::string accepted_message(const Fitted& fitted) {
  const std::string adapted = "the path was adapted";
  if (!fitted.of_partial_reference) return adapted;
  constexpr double kPercent = 100;
  return adapted + "; the reference shows only a part of the object, about " +
         std::to_string(std::lround(kPercent * fitted.explanation.inlier_ratio)) + " % of its scan";
}

/// The best mapping, or a refusal: nothing explains the object, or more than one mapping does.
Fitted choose(const Surface& reference, const Surface& object, const ToolPath& path,
              const StretchParameters& parameters, const Stages& stages, StretchResult& result) {
  PartialSearch partial(reference, object, parameters.prior);
  const std::vector<Candidate> candidates = find_candidates(
      reference, object, parameters.prior, partial, stages.within("align", 0.05, 0.5));
  if (candidates.empty()) {
    refuse_wrong_part(parameters.prior.pose || parameters.prior.scale.is_known()
                          ? "no pose of the reference fits it with the scale and the initial pose "
                            "given, as far as they may be off"
                          : "no pose of the reference fits the object at all");
  }
  const Eigen::Vector3d centroid = principal_frame(reference.points).centroid;
  std::vector<Fitted> fitted = fit_all(reference, object, path, candidates, parameters, stages);
  if (parameters.prior.pose) prefer_given_pose(*parameters.prior.pose, centroid, fitted);
  tell(fitted.front().mapping, fitted.front().explanation, result);
  if (fitted.front().explanation.inlier_ratio < parameters.min_inlier_ratio) {
    const auto whole = partial_reference(reference, object, path, partial, parameters);
    if (whole) fitted = {*whole};
    tell(fitted.front().mapping, fitted.front().explanation, result);
    if (!whole) {
      check_handedness(reference, object, fitted.front().mapping, fitted.front().explanation,
                       parameters);
      check_explained(fitted.front().explanation, parameters);
    }
  } else {
    check_handedness(reference, object, fitted.front().mapping, fitted.front().explanation,
                     parameters);
  }
  const Fitted& best = fitted.front();
  check_overlap(best.explanation, best.mapping.similarity, parameters);
  check_deformation(reference, best.mapping, parameters);
  for (std::size_t i = 1; i < fitted.size(); ++i) {
    check_unambiguous(path, best.mapping, fitted[i].mapping, reference, object, best.explanation,
                      fitted[i].explanation, parameters);
  }
  for (const Mapping& slid :
       slid_along_itself(reference, object, best.mapping, parameters.prior.scale)) {
    if (!parameters.prior.allows(slid.similarity, centroid)) continue;
    check_unambiguous(path, best.mapping, slid, reference, object, best.explanation,
                      explain(reference, object, slid, parameters.inlier_distance), parameters);
  }
  constexpr double kWhole = 0.95;
  if (std::min(best.explanation.overlap, best.explanation.inlier_ratio) < kWhole)
    check_rivals(path, reference, best.mapping, partial, parameters);
  return best;
}

void run(const Surface& reference, const Surface& object, const ToolPath& given,
         const StretchParameters& parameters, const Stages& stages, StretchResult& result) {
  stages.report("check", 0);
  check_surfaces(reference, object, parameters);
  check_path(given, reference, parameters);
  const ToolPath path = waypoints_of(given, parameters.resample_spacing);
  stages.report("align", 0.05);
  const Fitted chosen = choose(reference, object, path, parameters, stages, result);
  result.verdict.message = accepted_message(chosen);
  Mapping mapping = chosen.mapping;
  if (parameters.method == Method::kAffine) {
    mapping = affine_mapping(reference, object, mapping.similarity, parameters, stages);
    tell(mapping, explain(reference, object, mapping, parameters.inlier_distance), result);
  }
  stages.report("adapt", 0.9);
  const double spacing = mapping.similarity.scale * reference.spacing + object.spacing;
  Placement placement =
      place(path, reference, object, mapping,
            {parameters.support_radius, parameters.min_support, most_stranger(parameters, spacing),
             parameters.method == Method::kGeneral, parameters.stand_off == StandOff::kKeep});
  expect_errors(path, {reference, object, mapping, parameters.prior}, placement);
  result.quality = placement.quality;
  check_fold_over(path, placement.path, reference, object, mapping);
  check_placement(placement.quality, spacing, parameters);
  stages.report("done", 1);
  result.path = std::move(placement.path);
  result.reference_path = path;
}

}  // namespace

StretchResult stretch(const Surface& reference, const Surface& object, const ToolPath& path,
                      const StretchParameters& parameters, const Progress& progress) {
  check(parameters);
  const auto start = std::chrono::steady_clock::now();
  StretchResult result;
  result.method = parameters.method;
  result.reference_points = reference.points.size();
  result.object_points = object.points.size();
  try {
    run(reference, object, path, parameters, Stages(progress), result);
  } catch (const Refusal& refusal) {
    result.verdict = refusal.verdict;
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace tool_path_stretcher
