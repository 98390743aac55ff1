// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "verdict/ranking.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/points.h"
#include "verdict/ambiguity.h"

namespace tool_path_stretcher {
namespace {

/// Mean square residual in both directions. Each point's residual is taken relative to the most
/// that noise, sampling or grid explain, and capped there.
double capped_cost(const Explanation& explanation, double noise) {
  const auto mean = [noise](const Distances& distances) {
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < distances.off.size(); ++i) {
      if (std::isnan(distances.off[i])) continue;
      const double share = distances.off[i] / std::max(noise, distances.blur[i]);
      sum += std::min(share * share, 1.0);
      count += 1;
    }
    return count > 0 ? sum / count : 1;
  };
  return mean(explanation.object) + mean(explanation.reference);
}

}  // namespace

void sort_best_first(std::vector<Fitted>& fitted) {
  constexpr double kDeviations = 3;  // standard: 0.3 % of normal noise
  double noise = fitted.front().explanation.noise;
  for (const Fitted& each : fitted)
    noise = std::min(noise, each.explanation.noise);
  std::vector<std::pair<double, std::size_t>> order;
  for (const Fitted& each : fitted)
    order.emplace_back(capped_cost(each.explanation, kDeviations * noise), order.size());
  std::sort(order.begin(), order.end());
  std::vector<Fitted> sorted;
  for (const auto& [cost, index] : order)
    sorted.push_back(std::move(fitted[index]));
  fitted = std::move(sorted);
}

void drop_doubles(const Surface& reference, std::vector<Fitted>& fitted) {
  constexpr double kAlike = 0.01;  // of the size: as in the last round of the search
  const Points probes = select(reference.points, reference.samples.fewest);
  const auto is_double = [&](const Mapping& one, const Mapping& other) {
    return std::all_of(probes.begin(), probes.end(), [&](const Eigen::Vector3d& probe) {
      return (one * probe - other * probe).norm() < kAlike * one.similarity.scale * reference.size;
    });
  };
  std::vector<Fitted> kept;
  for (Fitted& each : fitted) {
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const Fitted& other) { return is_double(other.mapping, each.mapping); }))
      kept.push_back(std::move(each));
  }
  fitted = std::move(kept);
}

void keep_few(const ToolPath& path, double tolerance, std::vector<Fitted>& fitted) {
  constexpr std::size_t kMost = 4;  // chosen
  const Explanation& best = fitted.front().explanation;
  fitted.erase(
      std::remove_if(fitted.begin() + 1, fitted.end(),
                     [&](const Fitted& each) { return clearly_better(best, each.explanation); }),
      fitted.end());
  if (fitted.size() <= kMost) return;
  const Mapping first = fitted.front().mapping;
  std::stable_partition(fitted.begin() + 1, fitted.end(), [&](const Fitted& each) {
    return !same_path(path, first, each.mapping, tolerance);
  });
  fitted.resize(kMost);
}

void prefer_given_pose(const PosePrior& given, const Eigen::Vector3d& middle,
                       std::vector<Fitted>& fitted) {
  const auto off = [&](const Fitted& each) {
    return (each.mapping * middle - given.pose * middle).norm();
  };
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < fitted.size(); ++i) {
    if (clearly_better(fitted.front().explanation, fitted[i].explanation)) continue;
    if (off(fitted[i]) < off(fitted[nearest])) nearest = i;
  }
  std::swap(fitted.front(), fitted[nearest]);
}

}  // namespace tool_path_stretcher
