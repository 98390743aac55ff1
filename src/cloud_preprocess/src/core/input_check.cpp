// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "input_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/kd_tree.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::UnusableInput;

constexpr double kLargest = 20;       // [m] beyond what a robot scans; chosen
constexpr double kSmallest = 1e-3;    // [m] chosen
constexpr double kCoarsest = 6e-3;    // [m] between points: three cells of the stretcher's grid
constexpr std::size_t kFewest = 100;  // points; fewer tell no spacing; chosen

Cloud within_limits(const Cloud& cloud, const CleanParameters& parameters) {
  Cloud inside;
  for (const pcl::PointXYZ& point : cloud) {
    if (point.getVector3fMap().allFinite() && parameters.floor.limits.contain(point) &&
        parameters.outliers.limits.contain(point) && parameters.isolate.limits.contain(point))
      inside.push_back(point);
  }
  return inside;
}

/// On a surface, the distances in a random sample grow with the square root of the reduction.
double spacing_of(const Cloud& cloud, const Cloud& sample) {
  if (sample.size() < kFewest) return 0;
  const KdTree tree(sample);
  std::vector<KdTree::Index> indices(2);
  std::vector<float> squared(2);
  std::vector<double> distances;
  for (const pcl::PointXYZ& point : sample) {
    tree.nearest(point.data, indices.size(), indices.data(), squared.data());
    distances.push_back(std::sqrt(static_cast<double>(squared[1])));
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle *
         std::sqrt(static_cast<double>(sample.size()) / static_cast<double>(cloud.size()));
}

bool makes_sense(const CloudSize& size, double factor) {
  const double largest = size.extent.maxCoeff() * factor;
  return largest >= kSmallest && largest <= kLargest && size.spacing * factor <= kCoarsest;
}

/// "--units mm if it is 0.03 x 0.02 x 0.01 m, ...", for each unit that makes sense.
std::string sensible_units(const CloudSize& in_file) {
  std::string text;
  for (const std::string& unit : scan_cell_common::length_units()) {
    const double factor = scan_cell_common::metres_per(unit);
    if (!makes_sense(in_file, factor)) continue;
    text += (text.empty() ? "" : ", or ") + ("--units " + unit) + " if it is " +
            text_of({in_file.extent * factor, in_file.spacing * factor});
  }
  return text;
}

void refuse_sentinel(const Cloud& cloud, double metres, const std::string& name) {
  const auto found = scan_cell_common::find_sentinel(cloud);
  if (!found) return;
  const double in_file = found->value / metres;
  throw UnusableInput(
      name,
      fmt::format("{} of {} points have {} {:.7g}, away from all others: a scanner's number for "
                  "\"nothing measured\"",
                  found->points, cloud.size(), found->axis, in_file),
      fmt::format("drop them with --invalid {:.7g}, or cut them off by a limit", in_file));
}

}  // namespace

CloudSize measure(const Cloud& cloud, const CleanParameters& parameters) {
  constexpr std::size_t kSample = 20000;  // points; chosen
  constexpr double kOutermost = 0.005;    // of the points, at either end; chosen
  const Cloud inside = within_limits(cloud, parameters);
  CloudSize size;
  if (inside.empty()) return size;
  Cloud sample;
  std::mt19937 generator(1);
  std::sample(inside.begin(), inside.end(), std::back_inserter(sample), kSample, generator);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const pcl::PointXYZ& point : sample)
      values.push_back(static_cast<double>(point.data[axis]));
    std::sort(values.begin(), values.end());
    const auto skip = static_cast<std::size_t>(kOutermost * static_cast<double>(values.size()));
    size.extent[static_cast<Eigen::Index>(axis)] = values[values.size() - 1 - skip] - values[skip];
  }
  size.spacing = spacing_of(inside, sample);
  return size;
}

std::string text_of(const CloudSize& size) {
  const auto unit_of = [](double metres) { return metres < 1 ? "mm" : "m"; };
  const auto in_unit = [](double metres, double of) { return of < 1 ? metres * 1e3 : metres; };
  const double largest = size.extent.maxCoeff();
  const std::string text = fmt::format(
      "{:.3g} x {:.3g} x {:.3g} {}", in_unit(size.extent.x(), largest),
      in_unit(size.extent.y(), largest), in_unit(size.extent.z(), largest), unit_of(largest));
  if (size.spacing == 0) return text;
  return fmt::format("{}, {:.3g} {} between points", text, in_unit(size.spacing, size.spacing),
                     unit_of(size.spacing));
}

void check_input(const Cloud& cloud, const CleanParameters& parameters, const std::string& unit,
                 const std::string& name) {
  const double metres = unit.empty() ? 1 : scan_cell_common::metres_per(unit);
  const Cloud inside = within_limits(cloud, parameters);
  if (inside.size() < kFewest) return;
  refuse_sentinel(inside, metres, name);
  const CloudSize size = measure(inside, parameters);
  const double largest = size.extent.maxCoeff();
  const bool too_small = largest < kSmallest;
  if (largest == 0 || !(too_small || (unit.empty() && !makes_sense(size, 1)))) return;
  const CloudSize in_file{size.extent / metres, size.spacing / metres};
  const std::string units = sensible_units(in_file);
  throw UnusableInput(
      name,
      "in " + (unit.empty() ? "m" : unit) + " it is " + text_of(size) +
          (too_small ? ", smaller than anything that is scanned" : ", not a scan of a part"),
      units.empty() ? "check its unit (--units m, if it is in metres)" : "give " + units);
}

}  // namespace cloud_preprocess
