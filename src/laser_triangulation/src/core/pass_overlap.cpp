// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace laser_triangulation {
namespace {

constexpr std::size_t kMinCompared = 100;  // fewer tell nothing; chosen
constexpr std::size_t kMaxPartners = 8;    // of a sweep at one place; chosen
constexpr std::size_t kMaxRays = 20'000;   // from surface to camera; chosen
constexpr double kBeside = 0.7e-3;         // [m] lateral distance of a point above or below; chosen
constexpr double kPatch = 15e-3;         // [m] size of a surface that may have moved alone; chosen
constexpr std::size_t kMinOnPatch = 4;   // points whose median is not chance; chosen
constexpr std::size_t kMinApart = 20;    // points: a patch of several mm; chosen
constexpr double kMinShareApart = 0.02;  // of the points of a pair; chosen
constexpr double kMinShareShifted = 0.005;  // the same; a small part on a large table; chosen

/// [m] distance between two sweeps at a place; none if they cannot be compared there.
std::optional<double> distance(const SweepPatch& one, const SweepPatch& other) {
  if (!one.whole && !other.whole) return std::nullopt;
  const SweepPatch& surface = one.whole ? one : other;
  const SweepPatch& second = one.whole ? other : one;
  if (!same_side(surface, second)) return std::nullopt;
  const Eigen::Vector3d offset = second.nearest - surface.mean;
  if (second.whole) return std::abs(surface.normal.dot(offset));
  const double height = surface.normal.dot(offset);
  const double beside = (offset - height * surface.normal).norm();
  // A point nearer than that, or to the side, is at a rim. One above or below a whole surface is on
  // another surface.
  if (std::abs(height) < kApart || beside > kBeside) return std::nullopt;
  return std::abs(height);
}

/// The value below which this share of the values lies.
double quantile(std::vector<double>& values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Distances [m] between two sweeps.
struct PairDistances {
  using Patch = std::array<std::int64_t, 3>;

  void add(double distance, const Eigen::Vector3d& at) {
    const auto number = [&](int axis) { return std::llround(std::floor(at[axis] / kPatch)); };
    all.push_back(distance);
    on_patches[{number(0), number(1), number(2)}].push_back(distance);
  }

  std::size_t shifted() {
    std::size_t count = 0;
    for (auto& [patch, values] : on_patches)
      if (values.size() >= kMinOnPatch && quantile(values, 0.5) > kShifted) count += values.size();
    return count;
  }

  std::vector<double> all;
  std::map<Patch, std::vector<double>> on_patches;
};

using Distances = std::map<std::pair<std::size_t, std::size_t>, PairDistances>;

/// @param place number of the place
void compare_at(const std::vector<SweepPatch>& patches, std::size_t place, Distances& distances) {
  const auto compare = [&](const SweepPatch& one, const SweepPatch& other) {
    const auto found = distance(one, other);
    if (found) distances[{one.sweep, other.sweep}].add(*found, one.nearest);
  };
  const std::size_t count = patches.size();
  const std::size_t half = count / 2;
  for (std::size_t i = 0; i < count; ++i) {
    if (half > kMaxPartners) {  // different ones at each place
      for (std::size_t k = 0; k < kMaxPartners; ++k) {
        const std::size_t j = (i + 1 + (place * kMaxPartners + k) % half) % count;
        compare(patches[std::min(i, j)], patches[std::max(i, j)]);
      }
    } else {
      for (std::size_t j = i + 1; j < count; ++j)
        compare(patches[i], patches[j]);
    }
  }
}

/// Finds points that the camera saw through a whole patch of another sweep: two surfaces too far
/// apart to be compared, one of which was not there.
void look_through(const SharedPlaces& shared, const PlaceGrid& grid, const SweepPatch& seen,
                  Distances& distances) {
  constexpr double kBegin = 3e-3;        // [m] in front of the point; chosen
  constexpr double kEnd = 40e-3;         // [m] farther off, the parts are not small; chosen
  constexpr double kMiddle = 1e-3;       // [m] half of a patch's reach, well within it
  constexpr double kMinIncidence = 0.3;  // cosine: no ray along a surface; chosen
  const Eigen::Vector3d towards = (seen.from - seen.nearest).normalized();
  for (double at = SharedPlaces::kSearch; at < kEnd; at += SharedPlaces::kSearch) {
    const Eigen::Vector3d on_ray = seen.nearest + at * towards;
    for (const std::size_t place : grid.near(on_ray)) {
      if ((shared.centres[place] - on_ray).norm() > SharedPlaces::kSearch) continue;
      for (const SweepPatch& patch : shared.places[place]) {
        const double incidence = patch.normal.dot(towards);
        if (!patch.whole || patch.sweep == seen.sweep || std::abs(incidence) < kMinIncidence)
          continue;
        const double depth = patch.normal.dot(patch.mean - seen.nearest) / incidence;
        const bool beside = (seen.nearest + depth * towards - patch.mean).norm() > kMiddle;
        // Counts the crossing only at the nearest step along the ray.
        if (beside || depth < kBegin || std::abs(depth - at) > SharedPlaces::kSearch / 2) continue;
        distances[std::minmax(patch.sweep, seen.sweep)].add(depth, seen.nearest);
      }
    }
  }
}

}  // namespace

std::vector<PassOverlap> compare_sweeps(const SharedPlaces& shared) {
  Distances distances;
  for (std::size_t p = 0; p < shared.places.size(); ++p)
    compare_at(shared.places[p], p, distances);
  const PlaceGrid grid(shared.centres);
  std::size_t patches = 0;
  for (const std::vector<SweepPatch>& place : shared.places)
    patches += place.size();
  const std::size_t step = std::max<std::size_t>(1, patches / kMaxRays);
  std::size_t number = 0;
  for (const std::vector<SweepPatch>& place : shared.places) {
    for (const SweepPatch& seen : place)
      if (number++ % step == 0 && seen.whole) look_through(shared, grid, seen, distances);
  }
  std::vector<PassOverlap> overlaps;
  for (auto& [pair, found] : distances) {
    std::vector<double>& values = found.all;
    if (values.size() < kMinCompared) continue;
    const auto apart = std::count_if(values.begin(), values.end(),
                                     [](double distance) { return distance > kApart; });
    overlaps.push_back({shared.sweeps[pair.first], shared.sweeps[pair.second], values.size(),
                        quantile(values, 0.5), quantile(values, 0.95),
                        static_cast<std::size_t>(apart), found.shifted()});
  }
  return overlaps;
}

std::vector<Sweep> sweeps_alone(const SharedPlaces& shared,
                                const std::vector<PassOverlap>& overlaps) {
  const auto same = [](const Sweep& a, const Sweep& b) {
    return a.pass == b.pass && a.laser == b.laser;
  };
  std::vector<Sweep> alone;
  for (const Sweep& sweep : shared.sweeps) {
    const bool compared = std::any_of(overlaps.begin(), overlaps.end(), [&](const auto& overlap) {
      return same(overlap.one, sweep) || same(overlap.other, sweep);
    });
    if (!compared && shared.sweeps.size() > 1) alone.push_back(sweep);
  }
  return alone;
}

namespace {

/// @param points number of the pair's points concerned
/// @param share share above chance
bool is_more_than(double share, std::size_t points, const PassOverlap& overlap) {
  return points >= kMinApart &&
         static_cast<double>(points) >= share * static_cast<double>(overlap.points);
}

}  // namespace

bool disagree(const PassOverlap& overlap) {
  return is_more_than(kMinShareApart, overlap.apart, overlap);
}

bool is_shifted(const PassOverlap& overlap) {
  return overlap.median > kShifted || is_more_than(kMinShareShifted, overlap.shifted, overlap);
}

}  // namespace laser_triangulation
