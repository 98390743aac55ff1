// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict/handedness.h"

#include <optional>

#include "search/alignment.h"
#include "verdict/checks.h"

namespace tool_path_stretcher {
namespace {

const Eigen::Vector3d kMirror(-1, 1, 1);

void mirror(Points& points) {
  for (Eigen::Vector3d& point : points)
    point = point.cwiseProduct(kMirror);
}

/// Whether the first is clearly better, and next to nothing speaks for the second: of another part
/// that is neither, some would.
bool is_wholly_better(const Explanation& first, const Explanation& second) {
  constexpr double kContrary = 0.1;
  if (!clearly_better(first, second)) return false;
  const Evidence found = evidence(first, second);
  return found.only_second < kContrary * found.only_first;
}

/// Whether there is so little that the reference does not explain, undeformed, that its mirror
/// image cannot be clearly better: of few patches most points.
bool explains_all(const Explanation& explanation, const Mapping& mapping) {
  constexpr double kFew = 12;  // see clearly_better
  return mapping.graph.empty() && unexplained_patches(explanation) < kFew;
}

/// Of the poses of the mirror image the one that explains most, undeformed.
struct Image {
  Similarity similarity;
  Explanation explanation;
};
std::optional<Image> best_image(const Surface& image, const Surface& object,
                                const StretchParameters& parameters) {
  std::optional<Image> best;
  for (const Candidate& candidate : find_near_candidates(image, object, parameters.prior.scale)) {
    Explanation explanation =
        explain(image, object, {candidate.similarity, {}}, parameters.inlier_distance);
    if (best) {
      const Evidence found = evidence(explanation, best->explanation);
      if (found.only_first <= found.only_second) continue;
    }
    best = Image{candidate.similarity, std::move(explanation)};
  }
  return best;
}

}  // namespace

Surface mirrored(const Surface& surface) {
  Surface result = surface;
  mirror(result.points);
  mirror(result.normals);
  mirror(result.rim.points);
  mirror(result.rim.outward);
  result.tree = std::make_shared<const KdTree>(result.points);
  if (result.rim.tree) result.rim.tree = std::make_shared<const KdTree>(result.rim.points);
  return result;
}

void check_handedness(const Surface& reference, const Surface& object, const Mapping& best,
                      const Explanation& explanation, const StretchParameters& parameters) {
  if (explains_all(explanation, best)) return;
  const ScalePrior& scale = parameters.prior.scale;
  const Surface image = mirrored(reference);
  const std::optional<Image> found = best_image(image, object, parameters);
  if (!found) return;
  const auto explained = [&](const Surface& by, const Mapping& mapping) {
    return explain(by, object, mapping, parameters.inlier_distance);
  };
  const Mapping followed =
      fit_deformation(image, object, found->similarity, scale, parameters.deformation_level);
  const bool bent = !followed.graph.empty();
  const Explanation other = bent ? explained(image, followed) : found->explanation;
  if (other.inlier_ratio < parameters.min_inlier_ratio) return;
  if (is_wholly_better(other, explanation)) refuse_mirrored(other, explanation);
  if (bent || best.graph.empty() || clearly_better(explanation, other)) return;
  const Explanation undeformed = explained(reference, {best.similarity, {}});
  if (is_wholly_better(other, undeformed)) refuse_mirrored(other, undeformed);
}

}  // namespace tool_path_stretcher
