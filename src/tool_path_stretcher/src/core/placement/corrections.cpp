// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "placement/corrections.h"

#include <algorithm>
#include <cmath>

#include "geometry/robust.h"

namespace tool_path_stretcher {

double variance_beyond(const std::vector<double>& squares, const std::vector<double>& variances,
                       double median_of_one, double errors) {
  if (squares.empty()) return 0;
  return std::max(0.0, quantile(squares, 0.5) / median_of_one - errors * quantile(variances, 0.5));
}

Signal signal_of(const std::vector<Track>& tracks) {
  std::vector<double> heights, height_variances, slopes, slope_variances;
  for (const Track& track : tracks) {
    for (const auto& station : track.stations) {
      const LocalSurface& surface = station.surface;
      if (!surface.measured) continue;
      heights.push_back(surface.height * surface.height);
      height_variances.push_back(surface.height_variance);
      slopes.push_back(surface.slope.squaredNorm());
      slope_variances.push_back(surface.slope_variance);
    }
  }
  return {variance_beyond(heights, height_variances, kMedianOfOne, 1),
          variance_beyond(slopes, slope_variances, kMedianOfTwo, 1)};
}

namespace {

/// Smoothed height of one measured waypoint: the mean of the neighbours along the path, weighted by
/// their variance and a Gaussian of the arc length. The signal is that of the whole path, or of
/// this place if it alone stands out, as in a dent.
double smoothed(const Track& track, std::size_t at, double width, double signal) {
  constexpr double kReach = 6;      // widths: farther off, a Gaussian is near 0
  constexpr double kStandsOut = 9;  // variances: three standard deviations
  double weights = 0;
  double sum = 0;
  const Stretch near_by = around(track, at, kReach * width);
  for (std::size_t i = near_by.begin; i < near_by.end; i += near_by.step) {
    const LocalSurface& surface = track.stations[i].surface;
    if (!surface.measured) continue;
    const double steps = (track.arc_length[i] - track.arc_length[at]) / width;
    const double weight = std::exp(-steps * steps / 2) / (surface.height_variance + 1e-18);
    sum += weight * surface.height;
    weights += weight;
  }
  if (weights == 0) return 0;
  // Neighbours share scanned points, so their mean is trusted no more than the best of them.
  const double variance = track.stations[at].surface.height_variance;
  const double height = sum / weights;
  return followed(std::max(signal, height * height - kStandsOut * variance), variance) * height;
}

}  // namespace

std::vector<double> heights_along(const Track& track, double width, const Signal& signal) {
  const std::vector<Neighbours> neighbours = measured_neighbours(track);
  std::vector<double> measured(track.stations.size(), 0);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (track.stations[i].surface.measured)
      measured[i] = smoothed(track, i, width, signal.height_variance);
  }
  std::vector<double> result = measured;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (track.stations[i].surface.measured || track.stations[i].in_air) continue;
    result[i] = between(track, neighbours[i], i, 0.0, measured);
  }
  return result;
}

}  // namespace tool_path_stretcher
