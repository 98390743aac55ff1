// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict/partial_verdict.h"

#include "alignment/refinement.h"
#include "verdict/ambiguity.h"

namespace tool_path_stretcher {
namespace {

constexpr double kNoisier = 1.5;    // times the noise of the best; chosen
constexpr double kFewMore = 0.004;  // of the points known; chosen
constexpr int kIterations = 30;     // at most; chosen

/// Refuses if the other pose puts the path elsewhere.
void refuse_another(const ToolPath& path, const SurfacePair& surfaces, const Mapping& best,
                    const Similarity& other, const StretchParameters& parameters) {
  const Mapping mapping{other, {}};
  if (is_same_pose(best.similarity, other, surfaces.reference)) return;
  if (same_path(path, best, mapping, parameters.ambiguity_distance)) return;
  refuse_ambiguous(path, best, mapping);
}

}  // namespace

std::optional<Similarity> pose_of_partial_reference(const ToolPath& path,
                                                    const SurfacePair& surfaces,
                                                    PartialSearch& search,
                                                    const StretchParameters& parameters) {
  constexpr double kCostlier = 1.3;  // above: shares too little to be a rival; chosen
  if (!search.is_certain()) return {};
  const Candidate& best = search.fits().front();
  const double noise = best.agreement->noise;
  const double contradicted = best.agreement->contradicted(noise);
  for (const Candidate& other : search.fits()) {
    if (other.cost > kCostlier * best.cost) continue;
    if (other.agreement->noise > kNoisier * noise) continue;
    if (other.agreement->contradicted(noise) > 2 * contradicted + kFewMore) continue;
    refuse_another(path, surfaces, {best.similarity, {}}, other.similarity, parameters);
  }
  return refine(surfaces, best.similarity, parameters.prior.scale, Density::kMany, kIterations);
}

void check_rivals(const ToolPath& path, const SurfacePair& surfaces, const Mapping& best,
                  PartialSearch& search, const StretchParameters& parameters) {
  constexpr double kContradicted = 0.008;  // of the points known; chosen
  constexpr double kAgreeing = 0.98;       // of the points known; chosen
  constexpr double kShare = 0.25;          // of what contradicts the best; chosen
  constexpr double kWhole = 0.98;          // of the object's points; chosen
  const Agreement agreement = search.agreement(best);
  const double contradicted = agreement.contradicted(agreement.noise);
  const bool doubtful = contradicted >= kContradicted;
  const bool partial = agreement.object_known < kWhole;
  if (!doubtful && !partial && best.graph.empty()) return;
  const double most = doubtful && !partial ? kShare * contradicted : contradicted + kFewMore;
  const auto is_as_good = [&](const Agreement& other) {
    return other.agreeing >= kAgreeing && other.noise <= kNoisier * agreement.noise &&
           other.contradicted(agreement.noise) <= most;
  };
  for (const Candidate& other : search.fits()) {
    if (!is_as_good(*other.agreement)) continue;
    // Not fully refined, it may be the best pose beside its place.
    const Similarity refined =
        refine(surfaces, other.similarity, parameters.prior.scale, Density::kMany, kIterations);
    if (is_as_good(search.agreement({refined, {}})))
      refuse_another(path, surfaces, best, refined, parameters);
  }
}

}  // namespace tool_path_stretcher
