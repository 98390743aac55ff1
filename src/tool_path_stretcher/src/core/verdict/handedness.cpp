// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict/handedness.h"

#include <algorithm>
#include <optional>

#include "geometry/kd_tree.h"
#include "search/candidates.h"
#include "surface/complete_surface.h"
#include "verdict/checks.h"

namespace tool_path_stretcher {
namespace {

const Eigen::Vector3d kMirror(-1, 1, 1);

void mirror(Points& points) {
  for (Eigen::Vector3d& point : points)
    point = point.cwiseProduct(kMirror);
}

/// Whether the first is clearly better and almost nothing speaks for the second. Something would if
/// the object were another part.
bool is_wholly_better(const Explanation& first, const Explanation& second) {
  constexpr double kContrary = 0.2;  // of the patches that speak for the first; chosen
  if (!clearly_better(first, second)) return false;
  const Evidence found = evidence(first, second);
  return found.patches_second < kContrary * found.patches_first;
}

/// Whether the mirror image need not be deformed: undeformed, it is clearly worse than a mapping
/// that explains everything, or that explains most without a deformation. If a part is not
/// deformed, neither is its mirror image.
bool needs_no_deformation(const Fitted& best, const Explanation& image) {
  constexpr double kMost = 0.95;  // of either surface's points; chosen
  const Explanation& found = best.explanation;
  const bool most =
      best.mapping.graph.empty() && std::min(found.inlier_ratio, found.overlap) > kMost;
  return (most || explains_all(found)) && clearly_better(found, image);
}

/// Whether a deformation within the limits may bring enough of the object onto the mapped
/// reference.
bool may_be_followed(const Surface& reference, const Fitted& fitted,
                     const StretchParameters& parameters) {
  const double reach = parameters.inlier_distance + parameters.max_deformation_ratio *
                                                        fitted.mapping.similarity.scale *
                                                        length_of(reference);
  const std::vector<double>& off = fitted.explanation.object.off;
  const auto within =
      std::count_if(off.begin(), off.end(), [=](double distance) { return distance <= reach; });
  return static_cast<double>(within) >=
         parameters.min_inlier_ratio * static_cast<double>(off.size());
}

/// The mirror image of the surface: x becomes -x.
Surface mirrored(const Surface& surface) {
  Surface result = surface;
  mirror(result.points);
  mirror(result.normals);
  for (Rim* rim : {&result.rim, &result.edges}) {
    mirror(rim->points);
    mirror(rim->outward);
    if (rim->tree) rim->tree = std::make_shared<const KdTree>(rim->points);
  }
  result.centroid = result.centroid.cwiseProduct(kMirror);
  result.tree = std::make_shared<const KdTree>(result.points);
  return result;
}

/// All sides of a closed reference of which the surface is one view.
Surface all_sides(const Surface& reference) {
  Surface whole;
  whole.oriented = reference.oriented;
  whole.points = reference.whole->points();
  whole.normals = reference.whole_normals;
  complete(whole);
  return whole;
}

/// A mapping of the mirror image and one of the reference, each with its explanation.
struct Hands {
  const Fitted& image;
  const Fitted& itself;
};

/// Whether the mirror image is wholly better. For a closed reference, compares all sides, on the
/// object's points alone: a view does not hide the same sides of the part and of its image.
bool is_other_hand(const SurfacePair& surfaces, const Hands& hands, double inlier_distance) {
  const auto& [reference, object] = surfaces;
  if (!reference.whole) return is_wholly_better(hands.image.explanation, hands.itself.explanation);
  if (hands.image.explanation.inlier_ratio <= hands.itself.explanation.inlier_ratio) return false;
  const Surface whole = all_sides(reference);
  const Surface mirror_image = mirrored(whole);
  Explanation first = explain({mirror_image, object}, hands.image.mapping, inlier_distance);
  Explanation second = explain({whole, object}, hands.itself.mapping, inlier_distance);
  first.reference = second.reference = {};  // no scan shows them all
  return is_wholly_better(first, second);
}

/// The pose of the mirror image that explains most, undeformed.
/// @param bulk_cost [m] of the reference itself
std::optional<Fitted> best_image(const SurfacePair& image, const StretchParameters& parameters,
                                 double bulk_cost) {
  std::optional<Fitted> best;
  for (const Candidate& candidate :
       find_near_candidates(image, parameters.prior.scale, bulk_cost)) {
    Fitted found = fitted(image, {candidate.similarity, {}}, parameters.inlier_distance);
    if (best) {
      const Evidence between = evidence(found.explanation, best->explanation);
      if (between.only_first <= between.only_second) continue;
    }
    best = std::move(found);
  }
  return best;
}

}  // namespace

void check_handedness(const SurfacePair& surfaces, const Fitted& best,
                      const StretchParameters& parameters) {
  const bool all = explains_all(best.explanation);
  if (all && best.mapping.graph.empty()) return;
  const Surface mirror_image = mirrored(surfaces.reference);
  const SurfacePair image{mirror_image, surfaces.object};
  // A mapping that explains everything cannot be surpassed by a deformed image: the image must be
  // as good undeformed.
  const Candidate itself =
      judged(surfaces, all ? best.mapping : Mapping{best.mapping.similarity, {}}, Density::kFew);
  const std::optional<Fitted> found = best_image(image, parameters, itself.bulk_cost);
  if (!found) return;
  if (needs_no_deformation(best, found->explanation)) return;
  if (!may_be_followed(mirror_image, *found, parameters)) return;
  const Mapping followed = fit_deformation(image, found->mapping.similarity, parameters.prior.scale,
                                           parameters.deformation_level);
  const bool bent = !followed.graph.empty();
  const Fitted other = bent ? fitted(image, followed, parameters.inlier_distance) : *found;
  if (other.explanation.inlier_ratio < parameters.min_inlier_ratio) return;
  if (is_other_hand(surfaces, {other, best}, parameters.inlier_distance))
    refuse_mirrored(other.explanation, best.explanation);
  if (bent || best.mapping.graph.empty() || clearly_better(best.explanation, other.explanation))
    return;
  const Fitted undeformed =
      fitted(surfaces, {best.mapping.similarity, {}}, parameters.inlier_distance);
  if (is_other_hand(surfaces, {other, undeformed}, parameters.inlier_distance))
    refuse_mirrored(other.explanation, undeformed.explanation);
}

}  // namespace tool_path_stretcher
