// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/kd_tree.h"
#include "geometry/robust.h"
#include "placement/air.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"
#include "verdict/ambiguity.h"

namespace tool_path_stretcher {
namespace {

void check_enough(const Surface& surface, const std::string& name, int least) {
  if (surface.points.size() >= static_cast<std::size_t>(least)) return;
  refuse(Reason::kTooFewPoints, name,
         fmt::format("{} points after the grid reduction", surface.points.size()),
         fmt::format("scan more densely, reduce less (leaf), or lower min_points ({})", least));
}

constexpr double kLargest = 10;  // [m] beyond a robot's reach; chosen

/// A part of a few centimetres seems this large if millimetres are taken for metres.
void check_unit(const Surface& surface, const std::string& name) {
  if (surface.size < kLargest) return;
  refuse(Reason::kUnusableInput, name,
         fmt::format("its points lie {:.4g} m from their middle (RMS)", surface.size),
         "give it in metres, or state its unit (--units mm); it seems to be in millimetres or "
         "inches");
}

/// The share of a path's waypoints with a surface beside them.
double share_on(const PathDistances& distances) {
  const auto on = std::count(distances.in_air.begin(), distances.in_air.end(), false);
  return static_cast<double>(on) / static_cast<double>(distances.in_air.size());
}

ToolPath scaled(ToolPath path, double factor) {
  for (Segment& segment : path.segments) {
    for (Waypoint& waypoint : segment.waypoints)
      waypoint.pose.translation() *= factor;
  }
  return path;
}

/// The indices for which a flag is set.
std::vector<std::size_t> indices_of(const std::vector<bool>& flags) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i]) result.push_back(i);
  }
  return result;
}

/// The similarity that puts the points halfway between their positions under two others.
Similarity halfway(const Similarity& one, const Similarity& other, const Points& points) {
  Points between;
  for (const Eigen::Vector3d& point : points)
    between.push_back((one * point + other * point) / 2);
  return fit_similarity(points, between);
}

}  // namespace

void refuse(Reason reason, const std::string& thing, const std::string& value,
            const std::string& cure, std::vector<std::size_t> waypoints) {
  throw Refusal{{reason, thing + ": " + value + "; " + cure, std::move(waypoints)}};
}

void check_surfaces(const SurfacePair& surfaces, const StretchParameters& parameters) {
  constexpr double kOtherUnit = 100;  // chosen: between a part that grew and millimetres
  check_enough(surfaces.reference, "reference", parameters.min_points);
  check_enough(surfaces.object, "object", parameters.min_points);
  const double ratio = surfaces.object.size / surfaces.reference.size;
  if (ratio < kOtherUnit && ratio > 1 / kOtherUnit) {
    check_unit(surfaces.reference, "reference");
    check_unit(surfaces.object, "object");
    return;
  }
  refuse(Reason::kUnusableInput, "object",
         fmt::format("its size is {:.4g} times the reference's", ratio),
         "give both in metres, or state their units (--reference-units mm); a ratio near 1000 or "
         "0.001 means that one is in millimetres");
}

void check_path(const ToolPath& path, const Surface& reference,
                const StretchParameters& parameters) {
  constexpr double kLeast = 0.5;  // of the waypoints on the surface; chosen
  constexpr double kFar = 10;  // sizes of the reference: a path shrunk to a point lies on anything
  try {
    check(path);
  } catch (const scan_cell_common::UnusableInput& error) {
    throw Refusal{{Reason::kUnusableInput, error.what(), {}}};
  }
  const PathDistances distances = distances_of(path, reference, parameters);
  const double worst = *std::max_element(distances.far.begin(), distances.far.end());
  if (share_on(distances) >= kLeast && worst < kLargest) return;
  const std::vector<std::size_t> off = indices_of(distances.in_air);
  for (const char* const unit : {"inch", "mm"}) {  // a path shrunk too far lies on anything
    const double factor = scan_cell_common::metres_per(unit);
    if (!(worst > kFar * reference.size) ||
        share_on(distances_of(scaled(path, factor), reference, parameters)) <= kLeast)
      continue;
    refuse(Reason::kUnusableInput, "tool path",
           fmt::format("it lies on the reference only if it is divided by {:.4g}", 1 / factor),
           fmt::format("give it in metres, or state its unit (--path-units {})", unit), off);
  }
  refuse(Reason::kPathOffReference, "tool path",
         fmt::format("{} of {} waypoints lie off the reference, by more than {:.4g} mm and up to "
                     "{:.4g} mm",
                     off.size(), waypoint_count(path), distances.reach * 1e3, worst * 1e3),
         fmt::format("give the path in the reference's frame and in metres; at least half of its "
                     "waypoints must lie on the surface, or be guided over it at less than "
                     "max_stand_off ({:.4g} mm), and none may be {:.4g} m away",
                     parameters.max_stand_off * 1e3, kLargest),
         off);
}

void check_seeable(const ToolPath& path, const Surface& seeable,
                   const StretchParameters& parameters) {
  const double most = parameters.max_stand_off + seeable.spacing;
  const PathDistances whole = distances_of(path, seeable, parameters);
  std::vector<bool> hidden;
  for (const Eigen::Vector3d& at : positions_of(path)) {
    const std::size_t i = hidden.size();
    const double far = std::sqrt(seeable.tree->nearest(at).squared_distance);
    hidden.push_back(!whole.in_air[i] && far > std::max(most, whole.far[i] + seeable.spacing));
  }
  const std::vector<std::size_t> waypoints = indices_of(hidden);
  if (waypoints.empty()) return;
  refuse(Reason::kPathNotScanned, "tool path",
         fmt::format("{} of {} waypoints lie on a side of the part that the scan does not show",
                     waypoints.size(), waypoint_count(path)),
         "scan that side, or turn the part over", waypoints);
}

void refuse_wrong_part(const std::string& why) {
  refuse(Reason::kWrongPart, "object", why,
         "check that it is the same part as the reference, and the only thing in the scan");
}

void refuse_mirrored(const Explanation& mirrored, const Explanation& explanation) {
  refuse(Reason::kMirroredPart, "object",
         fmt::format("the mirror image of the reference explains {:.4g} % of its points, the "
                     "reference itself {:.4g} %, and only the mirror image explains its features",
                     100 * mirrored.inlier_ratio, 100 * explanation.inlier_ratio),
         "use the opposite-hand part, or the reference and path of this hand");
}

void refuse_search_at_bound(double scale, const StretchParameters& parameters) {
  refuse(
      Reason::kScaleAtBound, "scale",
      fmt::format("the best one, {:.4g}, is at an end of the searched range", scale),
      fmt::format("raise scale_range ({:.4g}) or use the general method", parameters.scale_range));
}

void check_explained(const Explanation& explanation, const StretchParameters& parameters) {
  if (explanation.inlier_ratio >= parameters.min_inlier_ratio) return;
  refuse_wrong_part(fmt::format(
      "the reference explains only {:.4g} % of its points to {:.4g} mm (min_inlier_ratio is "
      "{:.4g} %)",
      100 * explanation.inlier_ratio, parameters.inlier_distance * 1e3,
      100 * parameters.min_inlier_ratio));
}

void check_overlap(const Fitted& best, const StretchParameters& parameters) {
  if (best.explanation.overlap < parameters.min_overlap) {
    refuse_wrong_part(
        fmt::format("it shows only {:.4g} % of the reference (min_overlap is {:.4g} %)",
                    100 * best.explanation.overlap, 100 * parameters.min_overlap));
  }
  const double scale = best.mapping.similarity.scale;
  if (scale >= parameters.min_scale && scale <= parameters.max_scale) return;
  refuse(Reason::kScaleAtBound, "scale", fmt::format("{:.4g}", scale),
         fmt::format("only {:.4g} to {:.4g} is allowed (min_scale, max_scale)",
                     parameters.min_scale, parameters.max_scale));
}

void check_deformation(const Surface& reference, const Mapping& mapping,
                       const StretchParameters& parameters) {
  constexpr double kShare = 0.95;  // of the surface: as in max_deformation_ratio
  if (mapping.graph.empty()) return;
  std::vector<double> moved;
  for (const std::size_t i : reference.samples.few)
    moved.push_back(mapping.similarity.scale *
                    mapping.graph.displacement(reference.points[i]).norm());
  const double most = quantile(std::move(moved), kShare);
  const double limit =
      parameters.max_deformation_ratio * mapping.similarity.scale * length_of(reference);
  if (most <= limit) return;
  refuse_wrong_part(fmt::format(
      "the reference would have to be deformed by {:.4g} mm to fit it ({:.4g} mm is allowed: "
      "max_deformation_ratio, {:.4g} % of the part's length)",
      most * 1e3, limit * 1e3, 100 * parameters.max_deformation_ratio));
}

bool is_same_pose(const Similarity& one, const Similarity& other, const Surface& reference) {
  constexpr double kSamePose = 0.05;  // of the size: the same pose, refined less well; chosen
  return distance(one, other, reference.points) < kSamePose * one.scale * reference.size;
}

PoseCandidate candidate_of(const ToolPath& path, const Mapping& mapping) {
  PoseCandidate candidate{mapping.similarity, {}};
  for (const Segment& segment : path.segments) {
    for (const Waypoint& waypoint : segment.waypoints)
      candidate.waypoints.push_back(mapping * waypoint.pose.translation());
  }
  return candidate;
}

void refuse_ambiguous(const ToolPath& path, const Mapping& best, const Mapping& other) {
  const PoseCandidate one = candidate_of(path, best);
  const PoseCandidate two = candidate_of(path, other);
  double farthest = 0;
  for (std::size_t i = 0; i < one.waypoints.size(); ++i)
    farthest = std::max(farthest, (one.waypoints[i] - two.waypoints[i]).norm());
  throw Refusal{
      {Reason::kAmbiguous,
       fmt::format("pose: two poses explain the object equally well and put the path up to {:.4g} "
                   "mm apart; scan more of what breaks the part's symmetry, or say where the part "
                   "lies (initial pose)",
                   farthest * 1e3),
       {},
       {one, two}}};
}

bool check_unambiguous(const ToolPath& path, const SurfacePair& surfaces, const Fitted& best,
                       const Fitted& other, const StretchParameters& parameters) {
  const Similarity& one = best.mapping.similarity;
  const Similarity& two = other.mapping.similarity;
  if (is_same_pose(one, two, surfaces.reference)) return false;
  if (clearly_better(best.explanation, other.explanation)) return false;
  if (same_path(path, best.mapping, other.mapping, parameters.ambiguity_distance)) return true;
  if (parameters.prior.pose) {
    const Mapping between{halfway(one, two, surfaces.reference.points), best.mapping.graph};
    const Explanation explanation = explain(surfaces, between, parameters.inlier_distance);
    if (!clearly_better(best.explanation, explanation)) return false;
  }
  refuse_ambiguous(path, best.mapping, other.mapping);
}

}  // namespace tool_path_stretcher
