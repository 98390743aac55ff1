// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "isolation/objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "geometry/clusters.h"
#include "scan_cell_common/errors/errors.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::UnusableInput;

double middle(const Object& object, const Cloud& cells, std::size_t axis) {
  float least = std::numeric_limits<float>::infinity();
  float most = -least;
  for (const KdTree::Index cell : object.cells) {
    least = std::min(least, cells[cell].data[axis]);
    most = std::max(most, cells[cell].data[axis]);
  }
  return 0.5 * (static_cast<double>(least) + static_cast<double>(most));
}

double squared_distance(const Object& object, const Cloud& cells, const Eigen::Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const KdTree::Index cell : object.cells) {
    const Eigen::Vector3d mean = cells[cell].getVector3fMap().cast<double>();
    least = std::min(least, (mean - point).squaredNorm());
  }
  return least;
}

/// Index of the object with the smallest value.
template <class Value>
std::size_t least(const std::vector<Object>& objects, const Value& value) {
  const auto found =
      std::min_element(objects.begin(), objects.end(),
                       [&](const Object& a, const Object& b) { return value(a) < value(b); });
  return static_cast<std::size_t>(found - objects.begin());
}

}  // namespace

std::vector<Object> find_objects(const GridCells& grid, double gap, int min_points) {
  std::vector<std::size_t> points_in_cell(grid.means.size(), 0);
  for (const std::uint32_t cell : grid.cell_of_point)
    ++points_in_cell[cell];
  std::vector<Object> objects;
  std::size_t largest = 0;
  for (std::vector<KdTree::Index>& cells : clusters(grid.means, gap)) {
    Object object{std::move(cells), 0};
    for (const KdTree::Index cell : object.cells)
      object.points += points_in_cell[cell];
    largest = std::max(largest, object.points);
    if (object.points >= static_cast<std::size_t>(min_points)) objects.push_back(std::move(object));
  }
  if (objects.empty()) {
    throw UnusableInput("objects",
                        fmt::format("none has {} points, the largest has {}", min_points, largest),
                        "set a larger gap or smaller min_points");
  }
  return objects;
}

void sort_along(std::vector<Object>& objects, const Cloud& cells, Axis axis) {
  const auto number = static_cast<std::size_t>(axis);
  std::stable_sort(objects.begin(), objects.end(), [&](const Object& a, const Object& b) {
    return middle(a, cells, number) < middle(b, cells, number);
  });
}

std::size_t choose(const std::vector<Object>& objects, const Cloud& cells,
                   const IsolationParameters& parameters) {
  if (parameters.select == Selection::kNearest) {
    return least(objects,
                 [&](const Object& o) { return squared_distance(o, cells, parameters.point); });
  }
  if (parameters.select == Selection::kLargest)
    return least(objects, [](const Object& o) { return -static_cast<double>(o.points); });
  const auto index = static_cast<std::size_t>(parameters.index);
  if (index >= objects.size()) {
    throw UnusableInput("index", fmt::to_string(index),
                        fmt::format("there are {} objects, counted from 0: take another, or a "
                                    "smaller gap",
                                    objects.size()));
  }
  return index;
}

}  // namespace cloud_preprocess
