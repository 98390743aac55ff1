// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict/checks.h"

#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <sstream>

#include "geometry/robust.h"
#include "scan_cell_common/errors.h"
#include "scan_cell_common/units.h"
#include "verdict/ambiguity.h"

namespace tool_path_stretcher {
namespace {

std::string millimetres(double metres) {
  std::ostringstream text;
  text.precision(4);
  text << metres * 1e3 << " mm";
  return text.str();
}

std::string number(double value) {
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

[[noreturn]] void refuse(Reason reason, const std::string& thing, const std::string& value,
                         const std::string& cure, std::vector<std::size_t> waypoints = {}) {
  throw Refusal{{reason, thing + ": " + value + "; " + cure, std::move(waypoints)}};
}

void check_enough(const Surface& surface, const std::string& name, int least) {
  if (surface.points.size() >= static_cast<std::size_t>(least)) return;
  refuse(
      Reason::kTooFewPoints, name,
      std::to_string(surface.points.size()) + " points after the grid reduction",
      "scan more densely, reduce less (leaf), or lower min_points (" + std::to_string(least) + ")");
}

/// No part that a robot scans is so large; one of a few centimetres is, where millimetres are taken
/// for metres.
void check_unit(const Surface& surface, const std::string& name) {
  constexpr double kLargest = 10;  // [m]
  if (surface.size < kLargest) return;
  refuse(
      Reason::kUnusableInput, name,
      "its points lie " + number(surface.size) + " m from their middle (RMS)",
      "give it in metres, or say its unit (--units mm); it seems to be in millimetres or inches");
}

/// Whether the path lies on the reference once it is scaled.
bool lies_on(const Surface& reference, const ToolPath& path, double factor, double most) {
  for (const Segment& segment : path.segments) {
    for (const Waypoint& waypoint : segment.waypoints) {
      const Eigen::Vector3d at = factor * waypoint.pose.translation();
      if (reference.tree->nearest(at).squared_distance > most * most) return false;
    }
  }
  return true;
}

/// The waypoints where `bad` holds, and the worst value there.
struct Found {
  std::vector<std::size_t> waypoints;
  double worst = 0;
};

Found find(const std::vector<WaypointQuality>& quality,
           const std::function<double(const WaypointQuality&)>& value, double most) {
  Found found;
  for (std::size_t i = 0; i < quality.size(); ++i) {
    const double at = value(quality[i]);
    if (!(at > most)) continue;  // NaN is not known, and not bad
    found.waypoints.push_back(i);
    found.worst = std::max(found.worst, at);
  }
  return found;
}

std::string of_all(const Found& found, const std::vector<WaypointQuality>& quality) {
  return std::to_string(found.waypoints.size()) + " of " + std::to_string(quality.size()) +
         " waypoints";
}

PoseCandidate candidate_of(const ToolPath& path, const Mapping& mapping) {
  PoseCandidate candidate{mapping.similarity, {}};
  for (const Segment& segment : path.segments) {
    for (const Waypoint& waypoint : segment.waypoints)
      candidate.waypoints.push_back(mapping * waypoint.pose.translation());
  }
  return candidate;
}

/// The similarity that puts the points halfway between where two others put them.
Similarity halfway(const Similarity& one, const Similarity& other, const Points& points) {
  Points between;
  for (const Eigen::Vector3d& point : points)
    between.push_back((one * point + other * point) / 2);
  return fit_similarity(points, between);
}

/// Whether the mapping crushes space to nothing at a point of the reference, or turns it inside
/// out.
bool turned_over(const Mapping& mapping, const Eigen::Vector3d& at) {
  constexpr double kLeastVolume = 0.1;
  if (mapping.graph.empty()) return false;
  const Eigen::Matrix3d local = Eigen::Matrix3d::Identity() + mapping.graph.jacobian(at);
  return local.determinant() < kLeastVolume;
}

}  // namespace

void check_surfaces(const Surface& reference, const Surface& object,
                    const StretchParameters& parameters) {
  check_enough(reference, "reference", parameters.min_points);
  check_enough(object, "object", parameters.min_points);
  const double ratio = object.size / reference.size;
  constexpr double kOtherUnit = 100;
  if (ratio < kOtherUnit && ratio > 1 / kOtherUnit) {
    check_unit(reference, "reference");
    check_unit(object, "object");
    return;
  }
  refuse(Reason::kUnusableInput, "object",
         "its size is " + number(ratio) + " times the reference's",
         "give both in metres, or say their units (--reference-units mm); a ratio near 1000 or "
         "0.001 means that one is in millimetres");
}

void check_path(const ToolPath& path, const Surface& reference,
                const StretchParameters& parameters) {
  try {
    check(path);
  } catch (const scan_cell_common::UnusableInput& error) {
    throw Refusal{{Reason::kUnusableInput, error.what(), {}}};
  }
  const double most = parameters.max_path_distance + reference.spacing;
  std::vector<std::size_t> off;
  double worst = 0;
  std::size_t index = 0;
  for (const Segment& segment : path.segments) {
    for (const Waypoint& waypoint : segment.waypoints) {
      const double distance =
          std::sqrt(reference.tree->nearest(waypoint.pose.translation()).squared_distance);
      if (distance > most) {
        off.push_back(index);
        worst = std::max(worst, distance);
      }
      ++index;
    }
  }
  if (off.empty()) return;
  constexpr double kFar =
      10;  // sizes of the reference: any path shrinks to a point that lies on it
  for (const char* const unit : {"inch", "mm"}) {  // what is shrunk too far lies on anything
    const double factor = scan_cell_common::metres_per(unit);
    if (!(worst > kFar * reference.size) || !lies_on(reference, path, factor, most)) continue;
    refuse(Reason::kUnusableInput, "tool path",
           "it lies on the reference only once it is divided by " + number(1 / factor),
           std::string("give it in metres, or say its unit (--path-units ") + unit + ")", off);
  }
  refuse(Reason::kPathOffReference, "tool path",
         std::to_string(off.size()) + " of " + std::to_string(index) +
             " waypoints lie off the reference, by up to " + millimetres(worst),
         "give the path in the reference's frame and in metres, or raise max_path_distance (" +
             millimetres(parameters.max_path_distance) + ")",
         off);
}

void refuse_wrong_part(const std::string& why) {
  refuse(Reason::kWrongPart, "object", why,
         "check that it is the part of the reference, and alone in the scan");
}

void refuse_mirrored(const Explanation& mirrored, const Explanation& explanation) {
  refuse(Reason::kMirroredPart, "object",
         "the mirror image of the reference explains " + number(100 * mirrored.inlier_ratio) +
             " % of its points, the reference itself " + number(100 * explanation.inlier_ratio) +
             " %, and only the mirror image explains its features",
         "give the part of the other hand, or the reference and the path of this one");
}

void refuse_search_at_bound(double scale, const StretchParameters& parameters) {
  refuse(Reason::kScaleAtBound, "scale",
         "the best one, " + number(scale) + ", is an end of the range searched",
         "raise scale_range (" + number(parameters.scale_range) + ") or use the general method");
}

void check_explained(const Explanation& explanation, const StretchParameters& parameters) {
  if (explanation.inlier_ratio >= parameters.min_inlier_ratio) return;
  refuse_wrong_part("the reference explains only " + number(100 * explanation.inlier_ratio) +
                    " % of its points to " + millimetres(parameters.inlier_distance) +
                    " (min_inlier_ratio is " + number(100 * parameters.min_inlier_ratio) + " %)");
}

void check_overlap(const Explanation& explanation, const Similarity& similarity,
                   const StretchParameters& parameters) {
  if (explanation.overlap < parameters.min_overlap) {
    refuse_wrong_part("it shows only " + number(100 * explanation.overlap) +
                      " % of the reference (min_overlap is " +
                      number(100 * parameters.min_overlap) + " %)");
  }
  if (similarity.scale < parameters.min_scale || similarity.scale > parameters.max_scale) {
    refuse(Reason::kScaleAtBound, "scale", number(similarity.scale),
           "only " + number(parameters.min_scale) + " to " + number(parameters.max_scale) +
               " is allowed (min_scale, max_scale)");
  }
}

void check_deformation(const Surface& reference, const Mapping& mapping,
                       const StretchParameters& parameters) {
  if (mapping.graph.empty()) return;
  constexpr double kShare = 0.95;  // of the surface
  std::vector<double> moved;
  for (const std::size_t i : reference.samples.few)
    moved.push_back(mapping.similarity.scale *
                    mapping.graph.displacement(reference.points[i]).norm());
  const double most = quantile(std::move(moved), kShare);
  if (most <= parameters.max_deformation) return;
  refuse_wrong_part("the reference would have to be deformed by " + millimetres(most) +
                    " to fit it (max_deformation is " + millimetres(parameters.max_deformation) +
                    ")");
}

bool is_same_pose(const Similarity& one, const Similarity& other, const Surface& reference) {
  constexpr double kSamePose = 0.05;  // of the size: the same pose, not quite as well refined
  return distance(one, other, reference.points) < kSamePose * one.scale * reference.size;
}

void refuse_ambiguous(const ToolPath& path, const Mapping& best, const Mapping& other) {
  const PoseCandidate one = candidate_of(path, best);
  const PoseCandidate two = candidate_of(path, other);
  double farthest = 0;
  for (std::size_t i = 0; i < one.waypoints.size(); ++i)
    farthest = std::max(farthest, (one.waypoints[i] - two.waypoints[i]).norm());
  throw Refusal{{Reason::kAmbiguous,
                 "pose: two poses explain the object equally and put the path up to " +
                     millimetres(farthest) +
                     " apart; scan more of what breaks the part's symmetry, or say where the part "
                     "lies (initial pose)",
                 {},
                 {one, two}}};
}

void check_unambiguous(const ToolPath& path, const Mapping& best, const Mapping& other,
                       const Surface& reference, const Surface& object,
                       const Explanation& best_explanation, const Explanation& other_explanation,
                       const StretchParameters& parameters) {
  if (is_same_pose(best.similarity, other.similarity, reference)) return;
  if (clearly_better(best_explanation, other_explanation)) return;
  if (same_path(path, best, other, parameters.ambiguity_distance)) return;
  if (parameters.prior.pose) {
    const Mapping between{halfway(best.similarity, other.similarity, reference.points), best.graph};
    const Explanation explanation = explain(reference, object, between, parameters.inlier_distance);
    if (!clearly_better(best_explanation, explanation)) return;
  }
  refuse_ambiguous(path, best, other);
}

void check_fold_over(const ToolPath& path, const ToolPath& adapted, const Surface& reference,
                     const Surface& object, const Mapping& mapping) {
  const char* cure = "check the part and its scan, or lower deformation_level";
  std::vector<std::size_t> folded;
  std::size_t first = 0;
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const std::vector<Waypoint>& from = path.segments[s].waypoints;
    const std::vector<Waypoint>& to = adapted.segments[s].waypoints;
    const double step = object.spacing / mapping.similarity.scale;
    std::size_t last = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Eigen::Vector3d at = from[i].pose.translation();
      const Eigen::Vector3d way = at - from[last].pose.translation();
      const Eigen::Vector3d went = to[i].pose.translation() - to[last].pose.translation();
      const bool far_enough = way.norm() >= step;
      const bool back = far_enough && (mapping.similarity.rotation * way).dot(went) < 0;
      if (back || turned_over(mapping, at)) folded.push_back(first + i);
      if (far_enough) last = i;
    }
    first += from.size();
  }
  if (!folded.empty()) {
    refuse(
        Reason::kFoldOver, "adapted path",
        std::to_string(folded.size()) + " of " + std::to_string(first) +
            " waypoints run back where the path runs on, or lie where the surface is turned over",
        cure, folded);
  }
  std::size_t turned = 0;
  for (const std::size_t i : reference.samples.few)
    turned += turned_over(mapping, reference.points[i]);
  if (turned == 0) return;
  refuse(Reason::kFoldOver, "deformation",
         "it turns the surface over at " + std::to_string(turned) + " of " +
             std::to_string(reference.samples.few.size()) + " points",
         cure);
}

double most_stranger(const StretchParameters& parameters, double spacing) {
  return std::max(parameters.max_stranger, spacing);
}

void check_placement(const std::vector<WaypointQuality>& quality, double spacing,
                     const StretchParameters& parameters) {
  constexpr double kHole = 1.5;  // spacings: a sparse scan is not a hole
  constexpr double kTolerance = 0.2;
  const double most_hole = std::max(parameters.max_hole_distance, kHole * spacing);
  const double tolerance = std::max(parameters.tolerance, kTolerance * spacing);
  const Found holes = find(
      quality, [](const WaypointQuality& q) { return q.measured ? 0 : q.hole; }, most_hole);
  if (!holes.waypoints.empty()) {
    refuse(Reason::kPathNotScanned, "object",
           of_all(holes, quality) + " lie where it was not scanned, up to " +
               millimetres(holes.worst) + " from the scan",
           "scan there, or raise max_hole_distance (" + millimetres(parameters.max_hole_distance) +
               ")",
           holes.waypoints);
  }
  const Found gaps = find(
      quality,
      [](const WaypointQuality& q) {
        constexpr double kDeviations = 3;
        const double uncertain =
            kDeviations * q.residual / std::sqrt(std::max<double>(q.support, 1));
        return std::isnan(q.gap) ? uncertain : std::max(q.gap, uncertain);
      },
      tolerance);
  if (!gaps.waypoints.empty()) {
    refuse(Reason::kToleranceExceeded, "adapted path",
           of_all(gaps, quality) + " are up to " + millimetres(gaps.worst) +
               " from the scanned surface",
           "use the general method, or raise tolerance (" + millimetres(tolerance) + ")",
           gaps.waypoints);
  }
  constexpr double kLoose = 2;  // points: outliers of the scan
  const Found strange = find(
      quality, [](const WaypointQuality& q) { return static_cast<double>(q.strangers); }, kLoose);
  if (!strange.waypoints.empty()) {
    refuse(Reason::kWrongPart, "object",
           of_all(strange, quality) +
               " pass by a surface that is not on the reference, more than " +
               millimetres(most_stranger(parameters, spacing)) + " off it",
           "check that it is the part of the reference and that nothing lies on it, or raise "
           "max_stranger",
           strange.waypoints);
  }
  const Found moved = find(
      quality, [](const WaypointQuality& q) { return q.displacement; },
      parameters.max_displacement);
  if (!moved.waypoints.empty()) {
    refuse(Reason::kToleranceExceeded, "adapted path",
           of_all(moved, quality) + " were moved by up to " + millimetres(moved.worst) +
               " from where the similarity puts them",
           "check the part, or raise max_displacement (" +
               millimetres(parameters.max_displacement) + ")",
           moved.waypoints);
  }
}

}  // namespace tool_path_stretcher
