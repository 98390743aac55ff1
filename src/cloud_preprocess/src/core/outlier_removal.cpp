// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/outlier_removal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/kd_tree.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace cloud_preprocess {
namespace {

/// Mean distance [m] of each point to its nearest neighbours.
std::vector<double> mean_distances(const Cloud& cloud, int neighbours) {
  const KdTree tree(cloud);
  std::vector<KdTree::Index> indices(static_cast<std::size_t>(neighbours) + 1);  // and itself
  std::vector<float> squared(indices.size());
  std::vector<double> means(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::size_t found =
        tree.nearest(cloud[i].data, indices.size(), indices.data(), squared.data());
    double sum = 0;
    for (std::size_t k = 1; k < found; ++k)
      sum += std::sqrt(static_cast<double>(squared[k]));
    means[i] = found > 1 ? sum / static_cast<double>(found - 1) : 0;
  }
  return means;
}

/// Mean plus so many standard deviations of the distances, the far tail cut to ten medians.
double threshold(std::vector<double> distances, double deviations) {
  constexpr double kMaxMedians = 10;  // chosen
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  const double most = kMaxMedians * *middle;
  double sum = 0, squares = 0;
  for (const double distance : distances) {
    sum += std::min(distance, most);
    squares += std::min(distance, most) * std::min(distance, most);
  }
  const auto count = static_cast<double>(distances.size());
  const double variance = (squares - sum * sum / count) / std::max(count - 1, 1.0);
  return sum / count + deviations * std::sqrt(std::max(variance, 0.0));
}

}  // namespace

void describe(scan_cell_common::ParameterTable& table, OutlierParameters& parameters) {
  table.add("automatic", parameters.automatic, "statistical removal; false: limits only");
  table.add("neighbours", parameters.neighbours, {1, 200},
            "nearest points whose mean distance is looked at");
  table.add("deviations", parameters.deviations, {0, 100},
            "standard deviations above the mean that are still no outlier");
  describe(table, parameters.limits);
}

OutlierRemoval::OutlierRemoval(const OutlierParameters& parameters) : parameters_(parameters) {
  scan_cell_common::check(parameters_);
}

std::string OutlierRemoval::apply(TracedCloud& cloud) const {
  const std::string message = cut(cloud, parameters_.limits);
  if (!parameters_.automatic) return message + "not looked for others";

  const std::vector<double> distances = mean_distances(cloud.cloud(), parameters_.neighbours);
  const double most = threshold(distances, parameters_.deviations);
  const std::size_t removed = cloud.keep_if([&](std::size_t i) { return distances[i] <= most; });
  return fmt::format("{}{} more than {:.2f} mm from their neighbours", message, removed,
                     most * 1e3);
}

}  // namespace cloud_preprocess
