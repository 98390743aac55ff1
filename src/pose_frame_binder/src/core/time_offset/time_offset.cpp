// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "time_offset/time_offset.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "scan_cell_common/errors/errors.h"
#include "time_offset/offset_fit.h"
#include "time_offset/placed_scan.h"

namespace pose_frame_binder {
namespace {

using scan_cell_common::UnusableInput;

constexpr std::size_t kMaxPoints = 60'000;  // of a scan, in its tree; chosen
constexpr std::size_t kMaxAsked = 5'000;    // of a scan, paired with the other; chosen

/// The motion's direction and two directions across it.
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

/// Pairs points of `asked` with the planes of `there`.
/// @param sign +1 if `asked` is the backward scan, to which the shifts refer
void pair_up(const PlacedScan& asked, const PlacedScan& there, double sign, const Axes& axes,
             const TimeOffsetSettings& settings, std::vector<OffsetPair>& pairs) {
  constexpr double kBlock = 0.01;  // [m] chosen
  const std::size_t stride = asked.points().size() / kMaxAsked + 1;
  for (std::size_t i = 0; i < asked.points().size(); i += stride) {
    const PlacedScan::Point& point = asked.points()[i];
    const auto patch = there.patch_at(point.place);
    if (!patch) continue;
    const Eigen::Vector3d& normal = patch->normal;
    OffsetPair pair;
    pair.residual = normal.dot(point.place - patch->middle);
    pair.on_relief = std::abs(normal.dot(axes.along)) >= settings.min_relief;
    // Flat patches contribute only noise to the delay.
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

std::vector<OffsetPair> pair_up(const PlacedScan& forward, const PlacedScan& backward,
                                const Axes& axes, const TimeOffsetSettings& settings) {
  std::vector<OffsetPair> pairs;
  // In both directions, so that the distance of a curved surface from its patches' planes cancels
  // out.
  pair_up(backward, forward, 1, axes, settings, pairs);
  pair_up(forward, backward, -1, axes, settings, pairs);
  return pairs;
}

double root_mean_square(const std::vector<OffsetPair>& pairs) {
  double sum = 0;
  for (const OffsetPair& pair : pairs)
    sum += pair.residual * pair.residual;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(pairs.size(), 1)));
}

/// The delay at which the points of one scan, moved with their velocities, are nearest to those of
/// the other, to about a millimetre.
double search(const PlacedScan& forward, const PlacedScan& backward,
              const TimeOffsetSettings& settings) {
  constexpr double kStep = 1e-3;        // [m] chosen
  constexpr double kMaxSteps = 200;     // to either side; chosen
  constexpr std::size_t kAsked = 1500;  // points; chosen
  const double speed = (forward.mean_velocity() - backward.mean_velocity()).norm();
  const double steps = std::min(kMaxSteps, std::ceil(settings.max_delay * speed / kStep));
  const std::size_t stride = backward.points().size() / kAsked + 1;
  double best = 0, least = std::numeric_limits<double>::infinity();
  for (double step = -steps; step <= steps; ++step) {
    const double delay = step / steps * settings.max_delay;
    double sum = 0;
    for (std::size_t i = 0; i < backward.points().size(); i += stride) {
      const PlacedScan::Point& point = backward.points()[i];
      const Eigen::Vector3d place =
          point.place + delay * (point.velocity - forward.mean_velocity());
      sum += std::min(forward.distance(place), settings.max_distance);
    }
    if (sum >= least) continue;
    least = sum;
    best = delay;
  }
  return best;
}

void check_scan(const PlacedScan& scan, const char* name) {
  constexpr std::size_t kLeast = 1000;  // points; chosen
  if (scan.points().size() >= kLeast) return;
  throw UnusableInput(fmt::format("the scan {}", name),
                      fmt::format("{} points with poses", scan.points().size()),
                      "check its profiles, pulses and poses");
}

Axes check_directions(const PlacedScan& forward, const PlacedScan& backward) {
  const Eigen::Vector3d there = forward.mean_velocity(), back = backward.mean_velocity();
  constexpr double kMinSpeed = 1e-3;  // [m/s] chosen
  constexpr double kOpposite = -0.9;  // cosine; chosen
  if (there.norm() > kMinSpeed && back.norm() > kMinSpeed &&
      there.normalized().dot(back.normalized()) < kOpposite) {
    return axes_of(there - back);
  }
  throw UnusableInput("the two scans", "not in opposite directions",
                      "scan the scene there and back with the same orientation of the flange");
}

void check_overlap(const std::vector<OffsetPair>& pairs) {
  constexpr std::size_t kLeast = 500;  // points; chosen
  if (pairs.size() >= kLeast) return;
  throw UnusableInput("the two scans", fmt::format("{} points in common", pairs.size()),
                      "scan the same scene twice");
}

void check_relief(const TimeOffset& offset, const std::vector<OffsetPair>& pairs,
                  const TimeOffsetSettings& settings) {
  constexpr std::size_t kMinPairs = 200;  // chosen
  constexpr std::size_t kMinBlocks = 4;   // chosen
  std::map<int, int> blocks;
  for (const OffsetPair& pair : pairs)
    if (pair.on_relief) ++blocks[pair.block];
  const char* const cure =
      "add an object with slopes along the motion to the scene, such as a box on its edge or a "
      "pipe";
  if (offset.on_relief < kMinPairs || blocks.size() < kMinBlocks) {
    throw UnusableInput(
        "relief along the motion",
        fmt::format("{} of {} points lie on slopes", offset.on_relief, offset.pairs), cure);
  }
  if (!(offset.uncertainty <= settings.max_uncertainty)) {
    throw UnusableInput("time offset", fmt::format("uncertain by {:.3g} s", offset.uncertainty),
                        cure);
  }
}

}  // namespace

TimeOffset estimate_time_offset(const UnboundScan& forward, const UnboundScan& backward,
                                const TimeOffsetSettings& settings) {
  const PlacedScan there(forward, 0, kMaxPoints, settings);
  const PlacedScan back(backward, 0, kMaxPoints, settings);
  check_scan(there, "forward");
  check_scan(back, "backward");
  const Axes axes = check_directions(there, back);
  TimeOffset offset;
  offset.apart_before = root_mean_square(pair_up(there, back, axes, settings));
  offset.pose_delay = search(there, back, settings);

  constexpr int kMaxSteps = 25;        // chosen
  constexpr double kConverged = 0.03;  // of the uncertainty; chosen
  OffsetFit fit;
  for (int step = 0; step < kMaxSteps; ++step) {
    const std::vector<OffsetPair> pairs =
        pair_up(PlacedScan(forward, offset.pose_delay, kMaxPoints, settings),
                PlacedScan(backward, offset.pose_delay, kMaxPoints, settings), axes, settings);
    check_overlap(pairs);
    fit = fit_offset(pairs);
    offset.pairs = pairs.size();
    offset.on_relief = static_cast<std::size_t>(std::count_if(
        pairs.begin(), pairs.end(), [](const OffsetPair& pair) { return pair.on_relief; }));
    offset.from_posterior = fit.from_posterior;
    offset.from_residuals = fit.from_residuals;
    offset.uncertainty = std::max(fit.from_posterior, fit.from_residuals);
    offset.apart_after = root_mean_square(pairs);
    check_relief(offset, pairs, settings);
    offset.pose_delay += fit.solution[0];
    if (std::abs(fit.solution[0]) < kConverged * offset.uncertainty) break;
  }
  if (std::abs(fit.solution[0]) > offset.uncertainty ||
      std::abs(offset.pose_delay) > settings.max_delay) {
    throw UnusableInput("time offset",
                        fmt::format("did not converge near {:.6g} s", offset.pose_delay),
                        "check that both scans show the same scene, or raise max_delay");
  }
  return offset;
}

}  // namespace pose_frame_binder
