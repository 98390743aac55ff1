// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "placement/corrections.h"

namespace tool_path_stretcher {
namespace {

/// Whether no edge lies between two waypoints.
bool same_face(const Track& track, std::size_t one, std::size_t other) {
  constexpr double kSameFace = 0.9;  // cosine: up to 26 degrees; chosen
  return track.stations[one].surface.normal.dot(track.stations[other].surface.normal) > kSameFace;
}

/// A measured waypoint of one face, relative to another one.
struct Seen {
  double along;   // [widths] along the path
  double weight;  // a Gaussian of `along`
  const LocalSurface& surface;
};

std::vector<Seen> seen_from(const Track& track, std::size_t at, double width) {
  constexpr double kReach = 3;  // widths: farther off, a Gaussian is near 0
  std::vector<Seen> seen;
  const Stretch near_by = around(track, at, kReach * width);
  for (std::size_t i = near_by.begin; i < near_by.end; i += near_by.step) {
    if (!track.stations[i].surface.measured || !same_face(track, i, at)) continue;
    const double along = (track.arc_length[i] - track.arc_length[at]) / width;
    seen.push_back({along, std::exp(-along * along / 2), track.stations[i].surface});
  }
  return seen;
}

/// A slope that changes evenly along the path.
struct Trend {
  Eigen::Vector3d here = Eigen::Vector3d::Zero();
  Eigen::Vector3d change = Eigen::Vector3d::Zero();  // per width
  double variance = 1;                               // of `here`, relative to that of one waypoint
};

/// Fits by weighted least squares; without a change if the waypoints are too close together.
Trend trend_of(const std::vector<Seen>& seen) {
  constexpr double kSpread = 0.1;  // widths squared, mean; chosen
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Eigen::Matrix<double, 2, 3> right_side = Eigen::Matrix<double, 2, 3>::Zero();
  for (const Seen& each : seen) {
    const Eigen::Vector2d row(1, each.along);
    const double weight = each.weight / (each.surface.slope_variance + 1e-18);
    matrix += weight * row * row.transpose();
    right_side += weight * row * each.surface.slope.transpose();
  }
  if (matrix(0, 0) == 0) return {};
  const double spread = matrix.determinant() / std::pow(matrix(0, 0), 2);
  if (spread < kSpread) return {right_side.row(0) / matrix(0, 0), Eigen::Vector3d::Zero(), 1};
  const Eigen::Matrix<double, 2, 3> solution = matrix.inverse() * right_side;
  // Neighbours share scanned points: their common slope is trusted no more than one of them, and
  // less to one side of them.
  return {solution.row(0), solution.row(1), matrix(0, 0) * matrix(1, 1) / matrix.determinant()};
}

/// The common slope of neighbours along the path.
struct Slope {
  Eigen::Vector3d here;
  double variance;    // of each component
  double signal;      // of each component, of the waypoints around, as in a dent
  bool corroborated;  // by neighbours: a single waypoint sees an edge rather than a dent
  bool moved;         // the surface is also displaced there, as by a dent or a file
};

/// Variance, per component, of the slopes that most waypoints around show, beyond their errors.
double signal_around(const std::vector<Seen>& near) {
  constexpr std::size_t kLeast = 5;  // waypoints; chosen
  constexpr double kErrors = 4;      // variances: two standard deviations
  if (near.size() < kLeast) return 0;
  std::vector<double> squares, variances;
  for (const Seen& each : near) {
    squares.push_back(each.surface.slope.squaredNorm());
    variances.push_back(each.surface.slope_variance);
  }
  return variance_beyond(squares, variances, kMedianOfTwo, kErrors);
}

/// Whether the heights around are as large as such a slope implies. At an edge rounded off by
/// sampling and mixed points, they are far smaller.
bool moved_by(const Eigen::Vector3d& slope, const std::vector<Seen>& near, double width) {
  constexpr double kShare = 0.6;  // of the rise over a width; chosen
  const double least = kShare * slope.norm() * width;
  return std::any_of(near.begin(), near.end(),
                     [least](const Seen& each) { return std::abs(each.surface.height) >= least; });
}

Slope common_slope(const Track& track, std::size_t at, double width) {
  constexpr double kNear = 0.1;      // of the weight of the waypoint itself; chosen
  constexpr std::size_t kLeast = 3;  // waypoints that show it, including itself; chosen
  const std::vector<Seen> seen = seen_from(track, at, width);
  const Trend trend = trend_of(seen);
  double misfit = 0;
  double weights = 0;
  for (const Seen& each : seen) {
    const Eigen::Vector3d off = each.surface.slope - trend.here - each.along * trend.change;
    misfit += each.weight * off.squaredNorm() / 2 / (each.surface.slope_variance + 1e-18);
    weights += each.weight;
  }
  std::vector<Seen> near;
  std::copy_if(seen.begin(), seen.end(), std::back_inserter(near),
               [](const Seen& each) { return each.weight > kNear; });
  // They are trusted less if they disagree (Birge 1932).
  const double scatter = weights > 0 ? std::max(1.0, misfit / weights) : 1;
  return {trend.here, scatter * trend.variance * track.stations[at].surface.slope_variance,
          signal_around(near), near.size() >= kLeast, moved_by(trend.here, near, width)};
}

/// @param before prior variance of each component of the slope
Tilt measured_tilt(const Slope& slope, double before, bool follow) {
  constexpr double kStandsOut = 9;  // variances: three standard deviations
  constexpr double kDoubt = 0.01;   // one edge in a hundred is tilted but not displaced; chosen
  const double square = slope.here.squaredNorm() / 2;
  const double own = slope.corroborated ? square - kStandsOut * slope.variance : 0;
  const double shown = slope.moved ? std::max(slope.signal, own) : 0;
  const double likely = followed(std::max(before, shown), slope.variance);
  const double taken = follow ? likely : 0;
  const bool rounded_off = slope.corroborated && !slope.moved;
  const double doubt = rounded_off ? kDoubt * std::pow(1 - likely, 2) * square : 0;
  return {taken * slope.here,
          likely * slope.variance + std::pow(likely - taken, 2) * square + doubt};
}

}  // namespace

std::vector<Tilt> tilts_along(const Track& track, double width, const Signal& signal, bool follow) {
  const std::vector<Neighbours> neighbours = measured_neighbours(track);
  std::vector<Eigen::Vector3d> slopes(track.stations.size(), Eigen::Vector3d::Zero());
  std::vector<Tilt> tilts(track.stations.size());
  for (std::size_t i = 0; i < tilts.size(); ++i) {
    if (!track.stations[i].surface.measured) continue;
    const double before = track.stations[i].tilt_variance() + signal.slope_variance;
    tilts[i] = measured_tilt(common_slope(track, i, width), before, follow);
    slopes[i] = tilts[i].slope;
  }
  for (std::size_t i = 0; i < tilts.size(); ++i) {
    if (track.stations[i].surface.measured) continue;
    tilts[i].variance = track.stations[i].tilt_variance() + signal.slope_variance;
    if (track.stations[i].in_air) continue;
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    tilts[i].variance += between(track, neighbours[i], i, none, slopes).squaredNorm() / 2;
  }
  return tilts;
}

}  // namespace tool_path_stretcher
