// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "placement/placement.h"

#include <cmath>
#include <utility>

#include "geometry/kd_tree.h"
#include "placement/corrections.h"
#include "placement/stand_off.h"

namespace tool_path_stretcher {
namespace {

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// A placed waypoint and the corrections applied to it.
struct Placed {
  const Station& station;
  double height;          // [m, object] over the mapping
  Eigen::Vector3d slope;  // in the reference's frame
  double longer;          // [m] than the scaled stand-off
};

Eigen::Isometry3d carry_over(const Eigen::Isometry3d& pose, const Placed& placed,
                             const Mapping& mapping) {
  const Eigen::Vector3d& normal = placed.station.surface.normal;
  const Eigen::Matrix3d& turn = placed.station.turn;
  const Eigen::Quaterniond tilt = Eigen::Quaterniond::FromTwoVectors(normal, normal - placed.slope);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() = mapping * pose.translation() + placed.height * (turn * normal) +
                         placed.longer * (turn * (tilt * normal));
  result.linear() = Eigen::Quaterniond(turn * tilt.toRotationMatrix() * pose.linear())
                        .normalized()
                        .toRotationMatrix();
  return result;
}

WaypointQuality quality_of(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                           const Placed& placed, const Mapping& mapping, const Surface& object) {
  const auto distance_to_scan = [&object](const Eigen::Vector3d& point) {
    return std::sqrt(object.tree->nearest(point).squared_distance);
  };
  const auto& [in_air, surface, tool, turn, turn_covariance, covariance] = placed.station;
  const Eigen::Vector3d carried = mapping.similarity.rotation * surface.normal;
  WaypointQuality quality;
  quality.measured = surface.measured;
  quality.distance_to_scan = distance_to_scan(to);
  quality.support = surface.support;
  quality.residual = surface.residual;
  const Eigen::Vector3d kept = placed.longer * carried;
  quality.displacement = (to - mapping.similarity * from - kept).norm();
  quality.surface_angle =
      surface.measured ? angle_between(carried, turn * (surface.normal - surface.slope)) : kUnknown;
  quality.gap = surface.measured ? std::abs(placed.height - surface.height) : kUnknown;
  quality.strangers = surface.strangers.points;
  quality.in_air = in_air;
  if (in_air) {
    quality.hole = kUnknown;
  } else {
    quality.hole =
        distance_to_scan(mapping * surface.base + placed.height * (turn * surface.normal));
  }
  return quality;
}

double support_radius(const PlacementParameters& parameters, const Surface& object) {
  constexpr double kSpacings = 3;  // about 28 points
  return parameters.support_radius > 0 ? parameters.support_radius : kSpacings * object.spacing;
}

/// Places the waypoints, one segment after the other.
class Placer {
 public:
  Placer(const ToolPath& path, const SurfacePair& surfaces, const Mapping& mapping,
         const MappingError& mapping_error, const PlacementParameters& parameters)
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
      tracks_.push_back(
          survey(segment, {first, last}, path.has_orientation, {mapping, mapping_error, fitter}));
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
    constexpr double kSmoothing = 0.5;  // support radii; chosen
    constexpr double kTilts = 1.5;      // of that: a slope is noisier than a height; chosen
    const Segment& segment = placement_.path.segments[index];
    const Track& track = tracks_[index];
    const std::vector<double> none(track.stations.size(), 0);
    const double width = kSmoothing * radius_;
    const std::vector<double> heights =
        parameters_.set_on_surface ? heights_along(track, width, signal_) : none;
    const std::vector<Tilt> tilts =
        tilts_along(track, kTilts * width, signal_, parameters_.set_on_surface);
    const std::vector<double> standing =
        parameters_.keep_stand_off ? stand_offs(segment, track, surfaces_.reference) : none;
    for (std::size_t w = 0; w < none.size(); ++w) {
      const double longer = (1 - mapping_.similarity.scale) * standing[w];
      place(index, w, {track.stations[w], heights[w], tilts[w].slope, longer}, tilts[w].variance);
    }
  }

  void place(std::size_t segment, std::size_t waypoint, const Placed& placed,
             double tilt_variance) {
    Eigen::Isometry3d& pose = placement_.path.segments[segment].waypoints[waypoint].pose;
    const Eigen::Vector3d from = pose.translation();
    pose = carry_over(pose, placed, mapping_);
    if (!placement_.path.has_orientation) pose.linear().setIdentity();
    WaypointQuality quality =
        quality_of(from, pose.translation(), placed, mapping_, surfaces_.object);
    quality.segment = segment;
    quality.waypoint = waypoint;
    const Station& station = placed.station;
    PlacedHeight height;
    height.base = station.surface.base;
    height.normal = station.turn * station.normal;
    height.measured = station.surface.measured;
    height.seen = station.surface.height;
    height.variance = station.surface.height_variance;
    height.applied = placed.height;
    height.slope = station.turn * placed.slope;
    height.tilt_variance = tilt_variance;
    height.signal_variance = signal_.height_variance;
    height.slope_variance = signal_.slope_variance;
    height.hole = station.in_air ? 0 : quality.hole;
    height.covariance = station.covariance;
    height.turn_covariance = station.turn_covariance;
    placement_.strangers.push_back(station.surface.strangers.patch);
    placement_.heights.push_back(height);
    placement_.quality.push_back(quality);
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
                const MappingError& mapping_error, const PlacementParameters& parameters) {
  return Placer(path, surfaces, mapping, mapping_error, parameters).run();
}

}  // namespace tool_path_stretcher
