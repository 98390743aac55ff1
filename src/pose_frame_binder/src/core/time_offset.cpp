// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_frame_binder/time_offset.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "placed_scan.h"
#include "scan_cell_common/errors.h"

namespace pose_frame_binder {
namespace {

using scan_cell_common::UnusableInput;

constexpr std::size_t kMostPoints = 60'000;  // of a scan, in its tree
constexpr std::size_t kMostAsked = 5'000;    // of a scan, looked for in the other

/// residual + slope . (delay, two shifts across the motion) = 0 where the two scans agree.
struct Pair {
  Eigen::Vector3d slope;
  Eigen::Matrix3d slope_noise;  // its covariance
  double residual;              // [m]
  bool on_relief;
  int block;  // of the scene, along the motion
};

/// The motion's direction, and two across it.
struct Axes {
  Eigen::Vector3d along, first, second;
};

Axes axes_of(const Eigen::Vector3d& velocity) {
  Axes axes;
  axes.along = velocity.normalized();
  axes.first = axes.along.unitOrthogonal();
  axes.second = axes.along.cross(axes.first);
  return axes;
}

/// Points of `asked` on the planes of `there`.
/// @param sign +1 where `asked` is the scan that goes back: the shifts are its
void pair_up(const PlacedScan& asked, const PlacedScan& there, double sign, const Axes& axes,
             const TimeOffsetSettings& settings, std::vector<Pair>& pairs) {
  constexpr double kBlock = 0.01;  // [m]
  const std::size_t stride = asked.points().size() / kMostAsked + 1;
  for (std::size_t i = 0; i < asked.points().size(); i += stride) {
    const PlacedScan::Point& point = asked.points()[i];
    const auto patch = there.patch_at(point.place);
    if (!patch) continue;
    const Eigen::Vector3d& normal = patch->normal;
    Pair pair;
    pair.residual = normal.dot(point.place - patch->middle);
    pair.on_relief = std::abs(normal.dot(axes.along)) >= settings.least_relief;
    // Flat patches say nothing but their noise about the delay.
    Eigen::Matrix3d of_normal;
    of_normal.row(0) = (pair.on_relief ? 1 : 0) * (point.velocity - patch->velocity).transpose();
    of_normal.row(1) = sign * axes.first.transpose();
    of_normal.row(2) = sign * axes.second.transpose();
    pair.slope = of_normal * normal;
    pair.slope_noise = of_normal * patch->normal_noise * of_normal.transpose();
    pair.block = static_cast<int>(std::floor(axes.along.dot(point.place) / kBlock));
    pairs.push_back(pair);
  }
}

std::vector<Pair> pair_up(const PlacedScan& forward, const PlacedScan& backward, const Axes& axes,
                          const TimeOffsetSettings& settings) {
  std::vector<Pair> pairs;
  // Both ways round: what a curved surface is off its patches' planes cancels out.
  pair_up(backward, forward, 1, axes, settings, pairs);
  pair_up(forward, backward, -1, axes, settings, pairs);
  return pairs;
}

/// 1.4826 x the median: the standard deviation, were there no outliers.
double robust_deviation(const std::vector<Pair>& pairs, const Eigen::Vector3d& solution) {
  constexpr double kOfMedian = 1.4826;
  constexpr double kLeast = 1e-6;  // [m]
  std::vector<double> sizes;
  for (const Pair& pair : pairs)
    sizes.push_back(std::abs(pair.residual + pair.slope.dot(solution)));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return std::max(kLeast, kOfMedian * *middle);
}

struct Fit {
  Eigen::Vector3d solution = Eigen::Vector3d::Zero();
  double from_posterior = 0;
  double from_residuals = 0;
};

struct Equations {
  Eigen::Matrix3d noise = Eigen::Matrix3d::Zero();  // of the information
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

/// Normals that scatter tell the delay from a shift where the surface does not: the information
/// that comes of their noise is taken away (errors in variables).
double deviation_of_delay(const Equations& all, const Eigen::Matrix3d& prior) {
  Eigen::Matrix3d measured = all.information - prior;
  const double speed = std::sqrt(measured(0, 0) / (measured(1, 1) + measured(2, 2)));
  const Eigen::DiagonalMatrix<double, 3> to_metres(1 / speed, 1, 1);
  measured = to_metres * (measured - all.noise) * to_metres;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(measured);
  measured = axes.eigenvectors() * axes.eigenvalues().cwiseMax(0).asDiagonal() *
             axes.eigenvectors().transpose();
  const Eigen::Matrix3d information = measured + to_metres * prior * to_metres;
  return std::sqrt(information.inverse()(0, 0)) / speed;
}

/// How much the delay would change were one block of the scene left out, over all blocks
/// (jackknife): pairs of a block share their patches' and their poses' errors. These reach from
/// block to block: of blocks one, two and three times as long, those count that say most.
double jackknife(const Equations& all, const std::map<int, Equations>& blocks) {
  double most = 0;
  for (const int length : {1, 2, 3}) {
    std::map<int, Equations> longer;
    for (const auto& [number, block] : blocks) {
      Equations& sum = longer[static_cast<int>(std::floor(static_cast<double>(number) / length))];
      sum.information += block.information;
      sum.gradient += block.gradient;
    }
    double squares = 0;
    for (const auto& [number, block] : longer) {
      const Eigen::Matrix3d rest = all.information - block.information;
      squares += std::pow((rest.inverse() * block.gradient)[0], 2);
    }
    const auto count = static_cast<double>(longer.size());
    most = std::max(most, std::sqrt(squares * (count - 1) / count));
  }
  return most;
}

/// Iteratively reweighted least squares with Tukey's weights.
Fit solve(const std::vector<Pair>& pairs) {
  constexpr int kSteps = 20;
  constexpr double kTukey = 4.685;
  constexpr double kAlmostNothing =
      1e-6;                        // known of the delay, so that there is an inverse [1/s^2]
  constexpr double kShift = 1e-3;  // [m] how far off across the motion is to be expected
  const Eigen::Matrix3d prior =
      Eigen::Vector3d(kAlmostNothing, 1 / (kShift * kShift), 1 / (kShift * kShift)).asDiagonal();
  Fit fit;
  for (int step = 0; step < kSteps; ++step) {
    const double deviation = robust_deviation(pairs, fit.solution);
    Equations all;
    all.information = prior;
    all.gradient = prior * fit.solution;
    std::map<int, Equations> blocks;
    for (const Pair& pair : pairs) {
      const double residual = pair.residual + pair.slope.dot(fit.solution);
      const double share = residual / (kTukey * deviation);
      if (std::abs(share) >= 1) continue;
      const double weight = std::pow(1 - share * share, 2) / (deviation * deviation);
      for (Equations* equations : {&all, &blocks[pair.block]}) {
        equations->information += weight * pair.slope * pair.slope.transpose();
        equations->gradient += weight * residual * pair.slope;
        equations->noise += weight * pair.slope_noise;
      }
    }
    fit.solution -= all.information.inverse() * all.gradient;
    fit.from_posterior = deviation_of_delay(all, prior);
    fit.from_residuals = jackknife(all, blocks);
  }
  return fit;
}

double root_mean_square(const std::vector<Pair>& pairs) {
  double sum = 0;
  for (const Pair& pair : pairs)
    sum += pair.residual * pair.residual;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(pairs.size(), 1)));
}

/// The delay at which the points of the one scan lie nearest to those of the other, to about a
/// millimetre: they are carried along at their velocities.
double search(const PlacedScan& forward, const PlacedScan& backward,
              const TimeOffsetSettings& settings) {
  constexpr double kStep = 1e-3;  // [m]
  constexpr double kMostSteps = 200;
  constexpr std::size_t kAsked = 1500;
  const double speed = (forward.mean_velocity() - backward.mean_velocity()).norm();
  const double steps = std::min(kMostSteps, std::ceil(settings.most_delay * speed / kStep));
  const std::size_t stride = backward.points().size() / kAsked + 1;
  double best = 0, least = std::numeric_limits<double>::infinity();
  for (double step = -steps; step <= steps; ++step) {
    const double delay = step / steps * settings.most_delay;
    double sum = 0;
    for (std::size_t i = 0; i < backward.points().size(); i += stride) {
      const PlacedScan::Point& point = backward.points()[i];
      const Eigen::Vector3d place =
          point.place + delay * (point.velocity - forward.mean_velocity());
      sum += std::min(forward.distance(place), settings.most_distance);
    }
    if (sum >= least) continue;
    least = sum;
    best = delay;
  }
  return best;
}

void check_scan(const PlacedScan& scan, const char* name) {
  constexpr std::size_t kLeast = 1000;
  if (scan.points().size() >= kLeast) return;
  throw UnusableInput(std::string("the scan ") + name,
                      std::to_string(scan.points().size()) + " points with poses",
                      "check its profiles, pulses and poses");
}

Axes check_directions(const PlacedScan& forward, const PlacedScan& backward) {
  const Eigen::Vector3d there = forward.mean_velocity(), back = backward.mean_velocity();
  constexpr double kLeastSpeed = 1e-3;  // [m/s]
  constexpr double kOpposite = -0.9;    // cosine
  if (there.norm() > kLeastSpeed && back.norm() > kLeastSpeed &&
      there.normalized().dot(back.normalized()) < kOpposite) {
    return axes_of(there - back);
  }
  throw UnusableInput("the two scans", "not in opposite directions",
                      "scan the scene there and back, the flange turned the same way");
}

void check_overlap(const std::vector<Pair>& pairs) {
  constexpr std::size_t kLeast = 500;
  if (pairs.size() >= kLeast) return;
  throw UnusableInput("the two scans", std::to_string(pairs.size()) + " points in common",
                      "scan the same scene twice");
}

void check_relief(const TimeOffset& offset, const std::vector<Pair>& pairs,
                  const TimeOffsetSettings& settings) {
  constexpr std::size_t kLeastPairs = 200;
  constexpr std::size_t kLeastBlocks = 4;
  std::map<int, int> blocks;
  for (const Pair& pair : pairs)
    if (pair.on_relief) ++blocks[pair.block];
  const char* const cure =
      "put something with slopes along the motion there, such as a box on its edge or a pipe";
  if (offset.on_relief < kLeastPairs || blocks.size() < kLeastBlocks) {
    throw UnusableInput("relief along the motion",
                        std::to_string(offset.on_relief) + " of " + std::to_string(offset.pairs) +
                            " points lie on slopes",
                        cure);
  }
  if (!(offset.uncertainty <= settings.most_uncertainty)) {
    throw UnusableInput("time offset", "uncertain by " + std::to_string(offset.uncertainty) + " s",
                        cure);
  }
}

}  // namespace

TimeOffset estimate_time_offset(const UnboundScan& forward, const UnboundScan& backward,
                                const TimeOffsetSettings& settings) {
  const PlacedScan there(forward, 0, kMostPoints, settings);
  const PlacedScan back(backward, 0, kMostPoints, settings);
  check_scan(there, "forward");
  check_scan(back, "backward");
  const Axes axes = check_directions(there, back);
  TimeOffset offset;
  offset.apart_before = root_mean_square(pair_up(there, back, axes, settings));
  offset.pose_delay = search(there, back, settings);

  constexpr int kMostSteps = 25;
  constexpr double kConverged = 0.03;  // of the uncertainty
  Fit fit;
  for (int step = 0; step < kMostSteps; ++step) {
    const std::vector<Pair> pairs =
        pair_up(PlacedScan(forward, offset.pose_delay, kMostPoints, settings),
                PlacedScan(backward, offset.pose_delay, kMostPoints, settings), axes, settings);
    check_overlap(pairs);
    fit = solve(pairs);
    offset.pairs = pairs.size();
    offset.on_relief = static_cast<std::size_t>(
        std::count_if(pairs.begin(), pairs.end(), [](const Pair& pair) { return pair.on_relief; }));
    offset.from_posterior = fit.from_posterior;
    offset.from_residuals = fit.from_residuals;
    offset.uncertainty = std::max(fit.from_posterior, fit.from_residuals);
    offset.apart_after = root_mean_square(pairs);
    check_relief(offset, pairs, settings);
    offset.pose_delay += fit.solution[0];
    if (std::abs(fit.solution[0]) < kConverged * offset.uncertainty) break;
  }
  if (std::abs(fit.solution[0]) > offset.uncertainty ||
      std::abs(offset.pose_delay) > settings.most_delay) {
    throw UnusableInput("time offset",
                        "not settled near " + std::to_string(offset.pose_delay) + " s",
                        "check that both scans show the same scene, or raise most_delay");
  }
  return offset;
}

}  // namespace pose_frame_binder
