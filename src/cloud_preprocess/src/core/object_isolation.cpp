// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/object_isolation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/clusters.h"
#include "geometry/grid_cells.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::UnusableInput;

/// A cluster of cells, and so of points.
struct Object {
  std::vector<KdTree::Index> cells;
  std::size_t points = 0;
};

std::vector<Object> objects_of(const GridCells& grid, double gap) {
  std::vector<std::size_t> points_in_cell(grid.means.size(), 0);
  for (const std::uint32_t cell : grid.cell_of_point)
    ++points_in_cell[cell];
  std::vector<Object> objects;
  for (std::vector<KdTree::Index>& cells : clusters(grid.means, gap)) {
    Object object{std::move(cells), 0};
    for (const KdTree::Index cell : object.cells)
      object.points += points_in_cell[cell];
    objects.push_back(std::move(object));
  }
  return objects;
}

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

/// Puts the object that is asked for first: the one with the least value.
template <class Value>
void sort_by(std::vector<Object>& objects, const Value& value) {
  std::stable_sort(objects.begin(), objects.end(),
                   [&value](const Object& a, const Object& b) { return value(a) < value(b); });
}

/// Index of the object that is asked for, once they are in the order it is asked for in.
std::size_t choose(std::vector<Object>& objects, const Cloud& cells,
                   const IsolationParameters& parameters) {
  if (parameters.select == Selection::kNearest) {
    sort_by(objects, [&](const Object& o) { return squared_distance(o, cells, parameters.point); });
    return 0;
  }
  if (parameters.select == Selection::kLargest) {
    sort_by(objects, [](const Object& o) { return -static_cast<double>(o.points); });
    return 0;
  }
  const auto axis = static_cast<std::size_t>(parameters.axis);
  sort_by(objects, [&](const Object& o) { return middle(o, cells, axis); });
  const auto index = static_cast<std::size_t>(parameters.index);
  if (index >= objects.size()) {
    throw UnusableInput("index", fmt::to_string(index),
                        fmt::format("there are {} objects, counted from 0: take another, or a "
                                    "smaller gap",
                                    objects.size()));
  }
  return index;
}

std::vector<Object> large_enough(std::vector<Object> objects, int min_points) {
  std::size_t largest = 0;
  for (const Object& object : objects)
    largest = std::max(largest, object.points);
  const auto too_small = [min_points](const Object& object) {
    return object.points < static_cast<std::size_t>(min_points);
  };
  objects.erase(std::remove_if(objects.begin(), objects.end(), too_small), objects.end());
  if (objects.empty()) {
    throw UnusableInput("objects",
                        fmt::format("none of {} points, the largest has {}", min_points, largest),
                        "set a larger gap or smaller min_points");
  }
  return objects;
}

/// @return how many points went
std::size_t keep(TracedCloud& cloud, const GridCells& grid, const Object& object) {
  std::vector<bool> of_object(grid.means.size(), false);
  for (const KdTree::Index cell : object.cells)
    of_object[cell] = true;
  return cloud.keep_if([&](std::size_t i) { return of_object[grid.cell_of_point[i]]; });
}

}  // namespace

void describe(scan_cell_common::ParameterTable& table, IsolationParameters& parameters) {
  table.choice("select", parameters.select, {"all", "largest", "nearest", "index"},
               "the object to keep; all: limits only");
  table.add("gap", parameters.gap, {1e-4, 1, "m"}, "objects are at least about this far apart");
  table.add("min_points", parameters.min_points, {1, 1e9}, "fewer are no object");
  table.renamed("least_points", "min_points");
  table.add("point", parameters.point, {-1e3, 1e3, "m"}, "`nearest`: the object nearest to this");
  table.choice("axis", parameters.axis, {"x", "y", "z"},
               "`index`: objects are counted along it, by the middle of their extent");
  table.add("index", parameters.index, {0, 1e6}, "`index`: which of them, the first is 0");
  describe(table, parameters.limits);
}

ObjectIsolation::ObjectIsolation(const IsolationParameters& parameters) : parameters_(parameters) {
  scan_cell_common::check(parameters_);
}

std::string ObjectIsolation::apply(TracedCloud& cloud) const {
  const std::string message = cut(cloud, parameters_.limits);
  if (parameters_.select == Selection::kAll) return message + "all objects kept";

  // Cells much smaller than the gap stand for their points: a hundred times fewer steps.
  constexpr double kCellsAGap = 4;  // chosen
  const GridCells grid =
      sort_into_grid(cloud.cloud(), Eigen::Vector3d::Constant(parameters_.gap / kCellsAGap));
  std::vector<Object> objects =
      large_enough(objects_of(grid, parameters_.gap), parameters_.min_points);
  const Object& object = objects[choose(objects, grid.means, parameters_)];
  const std::size_t removed = keep(cloud, grid, object);
  return fmt::format("{}one of {} objects kept, {} points of others and of no object removed",
                     message, objects.size(), removed);
}

}  // namespace cloud_preprocess
