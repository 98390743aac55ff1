// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/object_isolation.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "geometry/grid_cells.h"
#include "isolation/objects.h"
#include "isolation/shadows.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace cloud_preprocess {
namespace {

/// @return how many points went
std::size_t keep(TracedCloud& cloud, const GridCells& grid, const Object& object) {
  std::vector<bool> of_object(grid.means.size(), false);
  for (const KdTree::Index cell : object.cells)
    of_object[cell] = true;
  return cloud.keep_if([&](std::size_t i) { return of_object[grid.cell_of_point[i]]; });
}

struct Found {
  GridCells grid;
  std::vector<Object> objects;  // along the axis
  std::size_t joined = 0;       // pieces, to others
};

Found find(const TracedCloud& cloud, const IsolationParameters& parameters) {
  // Cells much smaller than the gap stand for their points: a hundred times fewer steps.
  constexpr double kCellsAGap = 4;  // chosen
  Found found;
  found.grid =
      sort_into_grid(cloud.cloud(), Eigen::Vector3d::Constant(parameters.gap / kCellsAGap));
  found.objects = find_objects(found.grid, parameters.gap, parameters.min_points);
  if (parameters.across_shadows && cloud.floor() != nullptr) {
    found.joined =
        join_across_shadows(found.objects, found.grid.means, *cloud.floor(), parameters.gap);
  }
  sort_along(found.objects, found.grid.means, parameters.axis);
  return found;
}

std::string text_of_joined(std::size_t pieces) {
  if (pieces == 0) return "";
  return fmt::format(" ({} {} joined across what was not seen)", pieces,
                     pieces == 1 ? "piece" : "pieces");
}

}  // namespace

void describe(scan_cell_common::ParameterTable& table, IsolationParameters& parameters) {
  table.choice("select", parameters.select, {"all", "largest", "nearest", "index"},
               "the object to keep; all: limits only");
  table.add("gap", parameters.gap, {1e-4, 1, "m"}, "objects are at least about this far apart");
  table.add("min_points", parameters.min_points, {1, 1e9}, "fewer are no object");
  table.renamed("least_points", "min_points");
  table.add("across_shadows", parameters.across_shadows,
            "pieces between which the floor was not seen are one object, if a shadow can reach "
            "from one to the other");
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
  const Found found = find(cloud, parameters_);
  const Object& object = found.objects[choose(found.objects, found.grid.means, parameters_)];
  const std::size_t removed = keep(cloud, found.grid, object);
  return fmt::format("{}one of {} objects kept{}, {} points of others and of no object removed",
                     message, found.objects.size(), text_of_joined(found.joined), removed);
}

std::vector<TracedCloud> ObjectIsolation::objects(TracedCloud cloud) const {
  cut(cloud, parameters_.limits);
  if (parameters_.select == Selection::kAll) return {std::move(cloud)};
  const Found found = find(cloud, parameters_);
  std::vector<TracedCloud> result;
  for (const Object& object : found.objects)
    keep(result.emplace_back(cloud), found.grid, object);
  return result;
}

}  // namespace cloud_preprocess
