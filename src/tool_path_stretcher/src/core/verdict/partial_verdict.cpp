// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict/partial_verdict.h"

#include "verdict/ambiguity.h"

namespace tool_path_stretcher {
namespace {

constexpr double kNoisier = 1.5;
constexpr double kFewMore = 0.004;

/// Whether the two put the path to other places.
bool is_another(const ToolPath& path, const Surface& reference, const Mapping& one,
                const Mapping& other, double tolerance) {
  return !is_same_pose(one.similarity, other.similarity, reference) &&
         !same_path(path, one, other, tolerance);
}

}  // namespace

std::optional<Similarity> pose_of_partial_reference(const ToolPath& path, const Surface& reference,
                                                    const Surface& object, PartialSearch& search,
                                                    const StretchParameters& parameters) {
  constexpr double kCostlier = 1.3;  // and it shares too little to be a rival
  constexpr int kIterations = 30;
  if (!search.is_certain()) return {};
  const PartialFit& best = search.fits().front();
  const double noise = best.agreement.noise;
  const double contradicted = best.agreement.contradicted(noise);
  for (const PartialFit& other : search.fits()) {
    if (other.agreement.cost > kCostlier * best.agreement.cost) continue;
    if (other.agreement.noise > kNoisier * noise) continue;
    if (other.agreement.contradicted(noise) > 2 * contradicted + kFewMore) continue;
    const Mapping one{best.similarity, {}};
    const Mapping two{other.similarity, {}};
    if (is_another(path, reference, one, two, parameters.ambiguity_distance))
      refuse_ambiguous(path, one, two);
  }
  return refine(reference, object, best.similarity, parameters.prior.scale, Density::kMany,
                kIterations);
}

void check_rivals(const ToolPath& path, const Surface& reference, const Mapping& best,
                  PartialSearch& search, const StretchParameters& parameters) {
  constexpr double kContradicted = 0.008;
  constexpr double kAgreeing = 0.98;
  constexpr double kShare = 0.25;  // of what contradicts the best
  constexpr double kWhole = 0.97;
  const Agreement agreement = search.agreement(best);
  const double contradicted = agreement.contradicted(agreement.noise);
  const bool doubtful = contradicted >= kContradicted;
  const bool partial = agreement.object_known < kWhole;
  if (!doubtful && !partial && best.graph.empty()) return;
  const double most = doubtful && !partial ? kShare * contradicted : contradicted + kFewMore;
  for (const PartialFit& other : search.fits()) {
    if (other.agreement.agreeing < kAgreeing) continue;
    if (other.agreement.noise > kNoisier * agreement.noise) continue;
    if (other.agreement.contradicted(agreement.noise) > most) continue;
    const Mapping two{other.similarity, {}};
    if (is_another(path, reference, best, two, parameters.ambiguity_distance))
      refuse_ambiguous(path, best, two);
  }
}

}  // namespace tool_path_stretcher
