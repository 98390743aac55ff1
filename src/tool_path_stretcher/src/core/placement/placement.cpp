// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "placement/placement.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/kd_tree.h"
#include "geometry/robust.h"
#include "placement/local_surface.h"

namespace tool_path_stretcher {
namespace {

/// What a waypoint is moved by, over the mapping.
struct Correction {
  double height = 0;                                // [m, object]
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();  // of the height, in the reference's frame
};

/// One segment's waypoints, the surface beside each, and the arc length to each [m].
struct Track {
  std::vector<LocalSurface> surfaces;
  std::vector<bool> in_air;
  std::vector<double> arc_length;
};

/// How much heights and slopes vary along the whole path beyond what the noise explains.
struct Signal {
  double height_variance = 0;
  double slope_variance = 0;
};

/// The same surface with the normal to its other side.
void turn_over(LocalSurface& surface) {
  surface.normal = -surface.normal;
  surface.height = -surface.height;
  surface.slope = -surface.slope;
}

Track survey(const Segment& segment, std::vector<bool> in_air, const LocalSurfaceFitter& fitter,
             double scale) {
  Track track;
  track.in_air = std::move(in_air);
  double length = 0;
  for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
    const Eigen::Vector3d at = segment.waypoints[i].pose.translation();
    if (i > 0) length += scale * (at - segment.waypoints[i - 1].pose.translation()).norm();
    LocalSurface surface = track.in_air[i] ? fitter.far_from(at) : fitter.fit(at);
    // The sign of a cloud's normal is free; heights are compared along the path.
    if (i > 0 && surface.normal.dot(track.surfaces.back().normal) < 0) turn_over(surface);
    track.surfaces.push_back(surface);
    track.arc_length.push_back(length);
  }
  return track;
}

Signal signal_of(const std::vector<Track>& tracks) {
  Signal signal;
  double count = 0;
  for (const Track& track : tracks) {
    for (const LocalSurface& surface : track.surfaces) {
      if (!surface.measured) continue;
      signal.height_variance += surface.height * surface.height - surface.height_variance;
      signal.slope_variance += surface.slope.squaredNorm() / 2 - surface.slope_variance;
      count += 1;
    }
  }
  if (count == 0) return {};
  return {std::max(0.0, signal.height_variance / count),
          std::max(0.0, signal.slope_variance / count)};
}

/// Part of a measurement that is followed: all of it where the signal is far above its variance,
/// nothing where it is noise (Wiener 1949). The signal is that of the whole path, or that of this
/// place where it alone stands out, as in a dent.
double trust(double signal, double square, double variance) {
  constexpr double kStandsOut = 9;  // variances: three standard deviations
  const double here = std::max(signal, square - kStandsOut * variance);
  return here > 0 ? here / (here + variance) : 0;
}

/// Waypoints begin, begin + step .. end - 1 of a segment.
struct Stretch {
  std::size_t begin;
  std::size_t end;
  std::size_t step;
};

/// Those within `reach` [m] along the path; not all where they are far denser than any scan.
Stretch around(const Track& track, std::size_t at, double reach) {
  constexpr std::size_t kMost = 256;  // waypoints; chosen
  const std::vector<double>& lengths = track.arc_length;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(at);
  const auto first = std::lower_bound(lengths.begin(), middle, *middle - reach);
  const auto last = std::upper_bound(middle, lengths.end(), *middle + reach);
  const auto begin = static_cast<std::size_t>(first - lengths.begin());
  const auto end = static_cast<std::size_t>(last - lengths.begin());
  std::size_t step = 1;
  while ((end - begin) / step > kMost)
    step *= 2;
  return {(begin + step - 1) / step * step, end, step};
}

/// Mean of the neighbours along the path, by their variance and a Gaussian of the arc length.
Correction smoothed(const Track& track, std::size_t at, double width, const Signal& signal) {
  constexpr double kSlopeWidth = 2;           // widths: a slope is noisier than a height; chosen
  constexpr double kReach = 3 * kSlopeWidth;  // widths: beyond, a Gaussian is near 0
  double height_weight = 0;
  double slope_weight = 0;
  Correction sum;
  const Stretch near_by = around(track, at, kReach * width);
  for (std::size_t i = near_by.begin; i < near_by.end; i += near_by.step) {
    const LocalSurface& surface = track.surfaces[i];
    const double steps = (track.arc_length[i] - track.arc_length[at]) / width;
    if (!surface.measured || std::abs(steps) > kReach) continue;
    const double near = std::exp(-steps * steps / 2);
    const double slope_near = std::exp(-steps * steps / (2 * kSlopeWidth * kSlopeWidth));
    const double height_each = near / (surface.height_variance + 1e-18);
    const double slope_each = slope_near / (surface.slope_variance + 1e-18);
    sum.height += height_each * surface.height;
    sum.slope += slope_each * surface.slope;
    height_weight += height_each;
    slope_weight += slope_each;
  }
  if (height_weight == 0) return {};
  // Neighbours share scanned points: their mean is trusted no more than the best one of them.
  const LocalSurface& own = track.surfaces[at];
  const double height = sum.height / height_weight;
  const Eigen::Vector3d slope = sum.slope / slope_weight;
  return {trust(signal.height_variance, height * height, own.height_variance) * height,
          trust(signal.slope_variance, slope.squaredNorm() / 2, own.slope_variance) * slope};
}

/// Between the measured waypoints before and after, by arc length; nothing past the last one. Where
/// there is none before or after, that is `measured.size()`.
Correction inferred(const Track& track, const std::vector<Correction>& measured, std::size_t at,
                    std::size_t before, std::size_t after) {
  const bool has_before = before < measured.size();
  const bool has_after = after < measured.size();
  if (!has_before && !has_after) return {};
  if (!has_before || !has_after) return measured[has_before ? before : after];
  const double span = track.arc_length[after] - track.arc_length[before];
  const double share = span > 0 ? (track.arc_length[at] - track.arc_length[before]) / span : 0.5;
  return {(1 - share) * measured[before].height + share * measured[after].height,
          (1 - share) * measured[before].slope + share * measured[after].slope};
}

std::vector<Correction> corrections_of(const Track& track, double width, const Signal& signal) {
  const std::size_t count = track.surfaces.size();
  std::vector<Correction> corrections(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (track.surfaces[i].measured) corrections[i] = smoothed(track, i, width, signal);
  }
  std::vector<Correction> result = corrections;
  std::size_t before = count;
  std::size_t after = 0;
  for (std::size_t i = 0; i < count; ++i) {
    while (after < count && (after < i || !track.surfaces[after].measured))
      ++after;
    if (track.surfaces[i].measured) {
      before = i;
    } else if (!track.in_air[i]) {
      result[i] = inferred(track, corrections, i, before, after);
    }
  }
  return result;
}

/// [m] of a point over the surface beside it, along its normal, where it does not touch. Less than
/// the spacing shows, it touches; between, the two are blended.
double stand_off(const Surface& reference, const Eigen::Vector3d& at,
                 const Eigen::Vector3d& normal) {
  constexpr std::size_t kNeighbours = 7;  // chosen
  constexpr double kTouching = 0.3;       // spacings; chosen
  std::vector<KdTree::Neighbour> neighbours;
  reference.tree->nearest(at, kNeighbours, neighbours);
  std::vector<double> heights;
  for (const KdTree::Neighbour& neighbour : neighbours) {
    const Eigen::Vector3d& other = reference.normals[neighbour.index];
    const double height = other.dot(at - reference.points[neighbour.index]);
    heights.push_back(std::copysign(1.0, other.dot(normal)) * height);
  }
  const double height = quantile(std::move(heights), 0.5);
  const double touching = kTouching * reference.spacing;
  const double apart = std::clamp(std::abs(height) / touching - 1, 0.0, 1.0);
  return apart * height;
}

/// Whether a tool is led over a segment at one distance: a few waypoints past an edge make no
/// stand-off of it, nor does a way through the air.
bool is_even(const std::vector<double>& heights) {
  constexpr double kMaxTouching = 0.1;  // of the waypoints; chosen
  constexpr double kUneven = 0.2;       // of the stand-off; chosen
  const auto touching = static_cast<double>(std::count(heights.begin(), heights.end(), 0.0));
  if (touching > kMaxTouching * static_cast<double>(heights.size())) return false;
  const double middle = quantile(heights, 0.5);
  std::vector<double> off;
  for (const double height : heights)
    off.push_back(height - middle);
  return robust_deviation(std::move(off)) <= kUneven * std::abs(middle);
}

/// The stand-off of each waypoint of a segment; 0 for all where the segment has none.
std::vector<double> stand_offs(const Segment& segment, const Track& track,
                               const Surface& reference) {
  std::vector<double> result;
  for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
    const Eigen::Vector3d at = segment.waypoints[i].pose.translation();
    result.push_back(stand_off(reference, at, track.surfaces[i].normal));
  }
  const bool even = is_even(result);
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!even || track.in_air[i]) result[i] = 0;
  }
  return result;
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// A waypoint as it was placed, and what it was placed by.
struct Placed {
  bool in_air;
  const LocalSurface& surface;
  const Correction& correction;
  Eigen::Vector3d normal;  // of the surface; in the air the tool's axis, where that is known
  Eigen::Matrix3d turn;    // of that, from the reference to the object
  double longer;           // [m] than the scaled one the stand-off is
};

Eigen::Isometry3d carry_over(const Eigen::Isometry3d& pose, const Placed& placed,
                             const Mapping& mapping) {
  const Eigen::Vector3d at = pose.translation();
  const Eigen::Vector3d& normal = placed.surface.normal;
  const Eigen::Quaterniond tilt =
      Eigen::Quaterniond::FromTwoVectors(normal, normal - placed.correction.slope);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() = mapping * at + placed.correction.height * (placed.turn * normal) +
                         placed.longer * (placed.turn * (tilt * normal));
  result.linear() = Eigen::Quaterniond(placed.turn * tilt.toRotationMatrix() * pose.linear())
                        .normalized()
                        .toRotationMatrix();
  return result;
}

WaypointQuality quality_of(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                           const Placed& placed, const Mapping& mapping, const Surface& object) {
  const auto distance_to_scan = [&object](const Eigen::Vector3d& point) {
    return std::sqrt(object.tree->nearest(point).squared_distance);
  };
  const LocalSurface& surface = placed.surface;
  const double height = placed.correction.height;
  const Eigen::Vector3d carried = mapping.similarity.rotation * surface.normal;
  WaypointQuality quality;
  quality.measured = surface.measured;
  quality.distance_to_scan = distance_to_scan(to);
  quality.support = surface.support;
  quality.residual = surface.residual;
  const Eigen::Vector3d kept = placed.longer * carried;
  quality.displacement = (to - mapping.similarity * from - kept).norm();
  quality.surface_angle =
      surface.measured ? angle_between(carried, placed.turn * (surface.normal - surface.slope))
                       : kUnknown;
  quality.gap = surface.measured ? std::abs(height - surface.height) : kUnknown;
  quality.strangers = surface.strangers.points;
  quality.in_air = placed.in_air;
  quality.hole =
      placed.in_air
          ? kUnknown
          : distance_to_scan(mapping * surface.base + height * (placed.turn * surface.normal));
  return quality;
}

PlacedHeight height_of(const Placed& placed, const Signal& signal, double hole) {
  PlacedHeight height;
  height.base = placed.surface.base;
  height.normal = placed.turn * placed.normal;
  height.measured = placed.surface.measured;
  height.seen = placed.surface.height;
  height.variance = placed.surface.height_variance;
  height.applied = placed.correction.height;
  height.slope = placed.turn * placed.correction.slope;
  height.signal_variance = signal.height_variance;
  height.slope_variance = signal.slope_variance;
  height.hole = hole;
  return height;
}

double support_radius(const PlacementParameters& parameters, const Surface& object) {
  constexpr double kSpacings = 3;  // about 28 points
  return parameters.support_radius > 0 ? parameters.support_radius : kSpacings * object.spacing;
}

/// Places the waypoints of one segment after the other.
class Placer {
 public:
  Placer(const ToolPath& path, const SurfacePair& surfaces, const Mapping& mapping,
         const PlacementParameters& parameters)
      : surfaces_(surfaces),
        mapping_(mapping),
        parameters_(parameters),
        radius_(support_radius(parameters, surfaces.object)),
        placement_{path, {}, {}, {}} {
    const LocalSurfaceFitter fitter(surfaces, mapping, radius_, parameters.min_support,
                                    parameters.max_stranger);
    auto first = parameters.in_air.begin();
    for (const Segment& segment : path.segments) {
      const auto last = first + static_cast<std::ptrdiff_t>(segment.waypoints.size());
      tracks_.push_back(survey(segment, {first, last}, fitter, mapping.similarity.scale));
      first = last;
    }
    signal_ = signal_of(tracks_);
  }

  Placement run() {
    for (std::size_t s = 0; s < tracks_.size(); ++s)
      place(s);
    return std::move(placement_);
  }

 private:
  void place(std::size_t index) {
    Segment& segment = placement_.path.segments[index];
    const Track& track = tracks_[index];
    const std::vector<Correction> corrections =
        parameters_.set_on_surface ? corrections_of(track, radius_ / 2, signal_)
                                   : std::vector<Correction>(track.surfaces.size());
    const std::vector<double> standing = parameters_.keep_stand_off
                                             ? stand_offs(segment, track, surfaces_.reference)
                                             : std::vector<double>(corrections.size(), 0.0);
    for (std::size_t w = 0; w < corrections.size(); ++w) {
      Eigen::Isometry3d& pose = segment.waypoints[w].pose;
      const Eigen::Vector3d from = pose.translation();
      const LocalSurface& surface = track.surfaces[w];
      const bool in_air = track.in_air[w];
      const bool by_tool = in_air && placement_.path.has_orientation;
      const Eigen::Vector3d normal =
          by_tool ? Eigen::Vector3d(pose.linear().col(2)) : surface.normal;
      const Placed placed{in_air,
                          surface,
                          corrections[w],
                          normal,
                          mapping_.turn(in_air ? from : surface.base, normal),
                          (1 - mapping_.similarity.scale) * standing[w]};
      pose = carry_over(pose, placed, mapping_);
      if (!placement_.path.has_orientation) pose.linear().setIdentity();
      WaypointQuality quality =
          quality_of(from, pose.translation(), placed, mapping_, surfaces_.object);
      quality.segment = index;
      quality.waypoint = w;
      placement_.strangers.push_back(surface.strangers.patch);
      placement_.heights.push_back(height_of(placed, signal_, in_air ? 0 : quality.hole));
      placement_.quality.push_back(quality);
    }
  }

  const SurfacePair surfaces_;
  const Mapping& mapping_;
  const PlacementParameters& parameters_;
  double radius_;
  std::vector<Track> tracks_;
  Signal signal_;
  Placement placement_;
};

}  // namespace

Placement place(const ToolPath& path, const SurfacePair& surfaces, const Mapping& mapping,
                const PlacementParameters& parameters) {
  return Placer(path, surfaces, mapping, parameters).run();
}

}  // namespace tool_path_stretcher
