// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "placement/track.h"

#include <algorithm>

namespace tool_path_stretcher {
namespace {

/// Flips the normal to the surface's other side.
void turn_over(LocalSurface& surface) {
  surface.normal = -surface.normal;
  surface.height = -surface.height;
  surface.slope = -surface.slope;
}

Station station_at(const Waypoint& waypoint, bool in_air, bool has_orientation,
                   const Ground& ground) {
  const Eigen::Vector3d at = waypoint.pose.translation();
  Station station;
  station.in_air = in_air;
  station.covariance = ground.mapping_error.at(at);
  station.surface =
      in_air ? ground.fitter.far_from(at) : ground.fitter.fit(at, station.covariance.all);
  station.normal = in_air && has_orientation ? Eigen::Vector3d(waypoint.pose.linear().col(2))
                                             : station.surface.normal;
  const Eigen::Vector3d base = in_air ? at : station.surface.base;
  station.turn = ground.mapping.turn(base, station.normal);
  station.turn_covariance = ground.mapping_error.of_turn(base, station.normal, station.turn);
  return station;
}

}  // namespace

double Station::tilt_variance() const {
  const Eigen::Vector3d upward = turn * normal;
  return (turn_covariance.trace() - upward.dot(turn_covariance * upward)) / 2;
}

Track survey(const Segment& segment, const std::vector<bool>& in_air, bool has_orientation,
             const Ground& ground) {
  Track track;
  double length = 0;
  for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
    const Eigen::Vector3d at = segment.waypoints[i].pose.translation();
    if (i > 0) {
      length += ground.mapping.similarity.scale *
                (at - segment.waypoints[i - 1].pose.translation()).norm();
    }
    Station station = station_at(segment.waypoints[i], in_air[i], has_orientation, ground);
    // The sign of a cloud's normal is arbitrary, but heights are compared along the path.
    const bool turned =
        i > 0 && station.surface.normal.dot(track.stations.back().surface.normal) < 0;
    if (turned) turn_over(station.surface);
    if (turned && !in_air[i]) station.normal = -station.normal;
    track.stations.push_back(station);
    track.arc_length.push_back(length);
  }
  return track;
}

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

std::vector<Neighbours> measured_neighbours(const Track& track) {
  const std::size_t count = track.stations.size();
  std::vector<Neighbours> result;
  std::size_t before = count;
  std::size_t after = 0;
  for (std::size_t i = 0; i < count; ++i) {
    while (after < count && (after < i || !track.stations[after].surface.measured))
      ++after;
    if (track.stations[i].surface.measured) before = i;
    result.push_back({before, after});
  }
  return result;
}

double followed(double signal, double variance) {
  return signal > 0 ? signal / (signal + variance) : 0;
}

}  // namespace tool_path_stretcher
