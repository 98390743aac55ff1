// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict/placement_checks.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "scan_cell_common/pose/units.h"

namespace tool_path_stretcher {
namespace {

constexpr double kTolerance = 0.2;  // spacings; chosen

/// Whether the mapping nearly collapses space at a point of the reference, or turns it inside out.
bool turned_over(const Mapping& mapping, const Eigen::Vector3d& at) {
  constexpr double kMinVolume = 0.1;  // of the original volume; chosen
  if (mapping.graph.empty()) return false;
  const Eigen::Matrix3d local = Eigen::Matrix3d::Identity() + mapping.graph.jacobian(at);
  return local.determinant() < kMinVolume;
}

/// The waypoints of all segments where the adapted path runs backwards, or where the surface is
/// turned over.
/// @param step [m, reference] shorter steps are not checked
std::vector<std::size_t> folded_waypoints(const ToolPath& path, const ToolPath& adapted,
                                          const Mapping& mapping, double step) {
  std::vector<std::size_t> folded;
  std::size_t first = 0;
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const std::vector<Waypoint>& from = path.segments[s].waypoints;
    const std::vector<Waypoint>& to = adapted.segments[s].waypoints;
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
  return folded;
}

/// The waypoints whose value exceeds `most`, and the greatest value. NaN means unknown and is not
/// bad.
struct Found {
  template <class Value>
  Found(const std::vector<WaypointQuality>& quality, double most, const Value& value)
      : all(quality.size()) {
    for (std::size_t i = 0; i < quality.size(); ++i) {
      const double at = value(quality[i]);
      if (!(at > most)) continue;
      waypoints.push_back(i);
      worst = std::max(worst, at);
    }
  }

  /// @param text what is wrong with them, with {} for the worst value
  /// @param unit unit of the value in the text, relative to the value's own
  void refuse_if_any(Reason reason, const std::string& thing, const std::string& text,
                     const std::string& cure, double unit = 1e-3) const {
    if (waypoints.empty()) return;
    refuse(reason, thing,
           fmt::format("{} of {} waypoints ", waypoints.size(), all) +
               fmt::format(fmt::runtime(text), worst / unit),
           cure, waypoints);
  }

  std::size_t all;
  std::vector<std::size_t> waypoints;
  double worst = 0;
};

/// [m] to the scanned surface, or three deviations of that if more.
double gap_of(const WaypointQuality& quality) {
  constexpr double kDeviations = 3;  // standard: 0.3 % of normal noise
  const double uncertain =
      kDeviations * quality.residual / std::sqrt(std::max<double>(quality.support, 1));
  return std::isnan(quality.gap) ? uncertain : std::max(quality.gap, uncertain);
}

}  // namespace

void check_fold_over(const ToolPath& path, const ToolPath& adapted, const SurfacePair& surfaces,
                     const Mapping& mapping) {
  const char* cure = "check the part and its scan, or lower deformation_level";
  const std::vector<std::size_t> folded =
      folded_waypoints(path, adapted, mapping, surfaces.object.spacing / mapping.similarity.scale);
  if (!folded.empty()) {
    refuse(Reason::kFoldOver, "adapted path",
           fmt::format("{} of {} waypoints run backwards along the path, or lie where the "
                       "surface is turned over",
                       folded.size(), waypoint_count(path)),
           cure, folded);
  }
  std::size_t turned = 0;
  for (const std::size_t i : surfaces.reference.samples.few)
    turned += turned_over(mapping, surfaces.reference.points[i]);
  if (turned == 0) return;
  refuse(Reason::kFoldOver, "deformation",
         fmt::format("it turns the surface over at {} of {} points", turned,
                     surfaces.reference.samples.few.size()),
         cure);
}

namespace {

/// A waypoint over a hole is inferred from its neighbours. A path with most of its waypoints over
/// holes is refused. Waypoints in the air need no scan.
void check_measured(const std::vector<WaypointQuality>& quality) {
  const auto is_on = [](const WaypointQuality& each) { return !each.in_air; };
  const auto on = static_cast<std::size_t>(std::count_if(quality.begin(), quality.end(), is_on));
  const std::vector<std::size_t> inferred = Found(quality, 0, [](const WaypointQuality& q) {
                                              return q.in_air || q.measured ? 0.0 : 1.0;
                                            }).waypoints;
  if (inferred.size() < on && 2 * inferred.size() <= on) return;
  refuse(Reason::kPathNotScanned, "object",
         fmt::format("only {} of {} waypoints lie on a surface that was scanned",
                     on - inferred.size(), on),
         "scan the part along the path, more densely or from another side", inferred);
}

/// The largest patch beside any of the waypoints.
const StrangerPatch& largest(const Placement& placement,
                             const std::vector<std::size_t>& waypoints) {
  const auto smaller = [&](std::size_t one, std::size_t other) {
    return placement.strangers[one].area < placement.strangers[other].area;
  };
  return placement.strangers[*std::max_element(waypoints.begin(), waypoints.end(), smaller)];
}

void check_strangers(const Placement& placement, double spacing,
                     const StretchParameters& parameters) {
  constexpr double kLoose = 2;  // points: outliers of the scan; chosen
  const Found found(placement.quality, kLoose,
                    [](const WaypointQuality& q) { return static_cast<double>(q.strangers); });
  if (found.waypoints.empty()) return;
  const StrangerPatch& patch = largest(placement, found.waypoints);
  refuse(Reason::kWrongPart, "object",
         fmt::format("{} of {} waypoints pass by a surface that is not on the reference, more than "
                     "{:.4g} mm off it: {:.3g} mm2 about ({:.4g}, {:.4g}, {:.4g}) m",
                     found.waypoints.size(), found.all, max_stranger(parameters, spacing) * 1e3,
                     patch.area * 1e6, patch.middle.x(), patch.middle.y(), patch.middle.z()),
         "check that it is the part of the reference and that nothing lies on it, or raise "
         "max_stranger",
         found.waypoints);
}

/// [m] An initial pose comes with its own limit of error.
double max_position_error(const StretchParameters& parameters, double least) {
  const std::optional<PosePrior>& pose = parameters.prior.pose;
  return std::max({parameters.max_position_error, least, pose ? pose->distance : 0});
}

void check_uncertainty(const std::vector<WaypointQuality>& quality, const PlacementLimits& limits,
                       const StretchParameters& parameters) {
  const double max_error = limits.edges_are_known
                               ? max_position_error(parameters, kTolerance * limits.spacing)
                               : std::numeric_limits<double>::infinity();
  Found(quality, max_error,
        [](const WaypointQuality& q) { return q.in_air ? 0 : q.expected_error_tangential; })
      .refuse_if_any(
          Reason::kPositionUncertain, "adapted path",
          "may be off by {:.3g} mm along the surface (one standard deviation)",
          fmt::format("scan edges or features that show where the part lies along itself, give "
                      "the scale or the initial pose more closely, or raise max_position_error "
                      "({:.4g} mm)",
                      max_error * 1e3));
  using scan_cell_common::kDegree;
  Found(quality, parameters.max_orientation_error,
        [](const WaypointQuality& q) { return q.in_air ? 0 : q.expected_error_orientation; })
      .refuse_if_any(
          Reason::kOrientationUncertain, "adapted path",
          "have an orientation that may be off by {:.3g} deg (one standard deviation)",
          fmt::format("scan the surface beside them more densely and to both sides, or "
                      "raise max_orientation_error ({:.4g} rad, {:.3g} deg)",
                      parameters.max_orientation_error, parameters.max_orientation_error / kDegree),
          kDegree);
}

}  // namespace

double max_stranger(const StretchParameters& parameters, double spacing) {
  return std::max(parameters.max_stranger, spacing);
}

void check_placement(const Placement& placement, const PlacementLimits& limits,
                     const StretchParameters& parameters) {
  const std::vector<WaypointQuality>& quality = placement.quality;
  constexpr double kHole = 1.5;  // spacings: a sparse scan is not a hole; chosen
  const double spacing = limits.spacing;
  const double max_hole = std::max(parameters.max_hole_distance, kHole * spacing);
  const double tolerance = std::max(parameters.tolerance, kTolerance * spacing);
  Found(quality, max_hole, [](const WaypointQuality& q) { return q.measured ? 0 : q.hole; })
      .refuse_if_any(Reason::kPathNotScanned, "object",
                     "lie where it was not scanned, up to {:.4g} mm from the scan",
                     fmt::format("scan there, or raise max_hole_distance ({:.4g} mm)",
                                 parameters.max_hole_distance * 1e3));
  check_measured(quality);
  Found(quality, tolerance, gap_of)
      .refuse_if_any(
          Reason::kToleranceExceeded, "adapted path",
          "are up to {:.4g} mm from the scanned surface",
          fmt::format("use the general method, or raise tolerance ({:.4g} mm)", tolerance * 1e3));
  check_strangers(placement, spacing, parameters);
  const double max_displacement = parameters.max_displacement_ratio * limits.length;
  Found(quality, max_displacement,
        [](const WaypointQuality& q) { return q.in_air ? 0 : q.displacement; })
      .refuse_if_any(Reason::kToleranceExceeded, "adapted path",
                     "were moved by up to {:.4g} mm from where the similarity puts them",
                     fmt::format("check the part, or raise max_displacement_ratio ({:.4g} % of "
                                 "the part's length, {:.4g} mm)",
                                 100 * parameters.max_displacement_ratio, max_displacement * 1e3));
  check_uncertainty(quality, limits, parameters);
}

}  // namespace tool_path_stretcher
