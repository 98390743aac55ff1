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

/// Distances of the points from their neighbours.
class Spacing {
 public:
  Spacing(const Cloud& cloud, int neighbours)
      : cloud_(cloud),
        tree_(cloud),
        indices_(static_cast<std::size_t>(neighbours) + 1),  // and the point itself
        squared_(indices_.size()) {
    means_.reserve(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i)
      means_.push_back(mean_distance(i));
  }

  /// Mean plus `deviations` standard deviations [m] of the mean distances, capped at ten medians.
  double threshold(double deviations) const {
    constexpr double kMaxMedians = 10;  // chosen
    std::vector<double> sorted = means_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double most = kMaxMedians * *middle;
    double sum = 0, squares = 0;
    for (const double distance : means_) {
      sum += std::min(distance, most);
      squares += std::min(distance, most) * std::min(distance, most);
    }
    const auto count = static_cast<double>(means_.size());
    const double variance = (squares - sum * sum / count) / std::max(count - 1, 1.0);
    return sum / count + deviations * std::sqrt(std::max(variance, 0.0));
  }

  double mean(std::size_t i) const { return means_[i]; }

  /// Whether a point belongs to a part of the cloud that is equally sparse, like a flank in grazing
  /// light, and does not just lie beside a denser one.
  bool has_company(std::size_t i) {
    constexpr double kAlike = 1.5;  // between spacings in one part of a surface; chosen
    const std::size_t found = nearest(i);
    std::size_t alike = 0;
    for (std::size_t k = 1; k < found; ++k)
      alike += kAlike * means_[indices_[k]] >= means_[i];
    return 2 * alike >= found - 1;
  }

 private:
  std::size_t nearest(std::size_t i) {
    return tree_.nearest(cloud_[i].data, indices_.size(), indices_.data(), squared_.data());
  }

  double mean_distance(std::size_t i) {
    const std::size_t found = nearest(i);
    double sum = 0;
    for (std::size_t k = 1; k < found; ++k)
      sum += std::sqrt(static_cast<double>(squared_[k]));
    return found > 1 ? sum / static_cast<double>(found - 1) : 0;
  }

  const Cloud& cloud_;
  const KdTree tree_;
  std::vector<KdTree::Index> indices_;
  std::vector<float> squared_;
  std::vector<double> means_;  // [m] of each point
};

}  // namespace

void describe(scan_cell_common::ParameterTable& table, OutlierParameters& parameters) {
  table.add("automatic", parameters.automatic, "statistical removal; false: limits only");
  table.add("neighbours", parameters.neighbours, {1, 200},
            "number of nearest points whose mean distance is judged");
  table.add("deviations", parameters.deviations, {0, 100},
            "up to this many standard deviations above the mean a point is not an outlier");
  describe(table, parameters.limits);
}

OutlierRemoval::OutlierRemoval(const OutlierParameters& parameters) : parameters_(parameters) {
  scan_cell_common::check(parameters_);
}

std::string OutlierRemoval::apply(TracedCloud& cloud) const {
  const std::string message = cut(cloud, parameters_.limits);
  if (!parameters_.automatic) return message + "outliers not searched for";

  Spacing spacing(cloud.cloud(), parameters_.neighbours);
  const double most = spacing.threshold(parameters_.deviations);
  constexpr double kSparsest = 3;  // thresholds: light at most 73 degrees off the normal; chosen
  // Decides all before removing any: the tree refers to the cloud's own points.
  std::vector<bool> keep(cloud.cloud().size());
  for (std::size_t i = 0; i < keep.size(); ++i)
    keep[i] =
        spacing.mean(i) <= most || (spacing.mean(i) <= kSparsest * most && spacing.has_company(i));
  const std::size_t removed = cloud.keep_if([&](std::size_t i) { return keep[i]; });
  return fmt::format("{}{} more than {:.2f} mm from their neighbours", message, removed,
                     most * 1e3);
}

}  // namespace cloud_preprocess
