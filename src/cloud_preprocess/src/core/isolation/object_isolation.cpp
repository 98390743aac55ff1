// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/object_isolation.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/grid_cells.h"
#include "isolation/by_reference.h"
#include "isolation/objects.h"
#include "isolation/shadows.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"
#include "scan_cell_common/pose/units.h"

namespace cloud_preprocess {
namespace {

/// @return number of points removed
std::size_t keep(TracedCloud& cloud, const GridCells& grid, const Object& object) {
  std::vector<bool> of_object(grid.means.size(), false);
  for (const KdTree::Index cell : object.cells)
    of_object[cell] = true;
  return cloud.keep_if([&](std::size_t i) { return of_object[grid.cell_of_point[i]]; });
}

struct Found {
  GridCells grid;
  std::vector<Object> objects;  // along the axis
  std::size_t joined = 0;       // pieces joined to others
};

Found find(const TracedCloud& cloud, const IsolationParameters& parameters) {
  // Cells much smaller than the gap represent their points: a hundred times fewer steps.
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

std::string keep_by_reference(TracedCloud& cloud, const Found& found,
                              const IsolationParameters& parameters) {
  const ChosenPoints chosen = choose_by_reference(cloud, found.grid, found.objects, parameters);
  const std::size_t removed = cloud.keep_if([&](std::size_t i) { return chosen.kept[i]; });
  return fmt::format(
      "what '{}' explains kept{}, with {} points over it or less than {:g} mm beside it; {} points "
      "of other objects or of no object removed",
      parameters.reference, text_of_joined(found.joined), chosen.beside, parameters.gap * 1e3,
      removed);
}

float middle_along(const TracedCloud& object, Axis axis) {
  const auto less = [axis](const pcl::PointXYZ& one, const pcl::PointXYZ& other) {
    return one.data[static_cast<std::size_t>(axis)] < other.data[static_cast<std::size_t>(axis)];
  };
  const auto [least, most] =
      std::minmax_element(object.cloud().begin(), object.cloud().end(), less);
  return (least->data[static_cast<std::size_t>(axis)] +
          most->data[static_cast<std::size_t>(axis)]) /
         2;
}

/// The object kept, and the rest of the others, along the axis.
std::vector<TracedCloud> beside(std::vector<TracedCloud> objects, const TracedCloud& kept,
                                const IsolationParameters& parameters) {
  std::vector<std::uint32_t> sources = kept.sources();
  std::sort(sources.begin(), sources.end());
  std::vector<TracedCloud> result = {kept};
  for (TracedCloud& object : objects) {
    object.keep_if([&](std::size_t i) {
      return !std::binary_search(sources.begin(), sources.end(), object.sources()[i]);
    });
    if (object.cloud().size() >= static_cast<std::size_t>(parameters.min_points))
      result.push_back(std::move(object));
  }
  std::stable_sort(result.begin(), result.end(), [&](const auto& one, const auto& other) {
    return middle_along(one, parameters.axis) < middle_along(other, parameters.axis);
  });
  return result;
}

}  // namespace

void describe(scan_cell_common::ParameterTable& table, IsolationParameters& parameters) {
  table.choice("select", parameters.select, {"all", "largest", "nearest", "index", "reference"},
               "the object to keep; all: limits only");
  table.add("gap", parameters.gap, {1e-4, 1, "m"}, "objects are at least about this far apart");
  table.add("min_points", parameters.min_points, {1, 1e9}, "fewer points are not an object");
  table.renamed("least_points", "min_points");
  table.add("across_shadows", parameters.across_shadows,
            "pieces between which the floor was not seen are one object, if a shadow can reach "
            "from one to the other");
  table.add("point", parameters.point, {-1e3, 1e3, "m"}, "`nearest`: the object nearest to this");
  table.choice("axis", parameters.axis, {"x", "y", "z"},
               "`index`: objects are counted along it, by the middle of their extent");
  table.add("index", parameters.index, {0, 1e6}, "`index`: number of the object; the first is 0");
  table.add("reference", parameters.reference,
            "`reference`: file of the part to look for, a cloud or a mesh");
  table.choice("reference_units", parameters.reference_units, scan_cell_common::length_units(),
               "`reference`: unit of that file");
  if (parameters.select == Selection::kReference && parameters.reference.empty())
    table.refuse("reference", "not set", "give the file of the part to look for");
  describe(table, parameters.limits);
}

ObjectIsolation::ObjectIsolation(const IsolationParameters& parameters) : parameters_(parameters) {
  scan_cell_common::check(parameters_);
  if (parameters_.select == Selection::kReference && !parameters_.finder) {
    throw scan_cell_common::InvalidParameter("select", "reference",
                                             "give a finder that has loaded the reference");
  }
}

std::string ObjectIsolation::apply(TracedCloud& cloud) const {
  const std::string message = cut(cloud, parameters_.limits);
  if (parameters_.select == Selection::kAll) return message + "all objects kept";
  const Found found = find(cloud, parameters_);
  if (parameters_.select == Selection::kReference)
    return message + keep_by_reference(cloud, found, parameters_);
  const Object& object = found.objects[choose(found.objects, found.grid.means, parameters_)];
  const std::size_t removed = keep(cloud, found.grid, object);
  return fmt::format(
      "{}one of {} objects kept{}, {} points of other objects or of no object removed", message,
      found.objects.size(), text_of_joined(found.joined), removed);
}

std::vector<TracedCloud> ObjectIsolation::objects(TracedCloud cloud,
                                                  const TracedCloud& kept) const {
  cut(cloud, parameters_.limits);
  if (parameters_.select == Selection::kAll) return {std::move(cloud)};
  const Found found = find(cloud, parameters_);
  std::vector<TracedCloud> result;
  for (const Object& object : found.objects)
    keep(result.emplace_back(cloud), found.grid, object);
  return parameters_.select == Selection::kReference ? beside(std::move(result), kept, parameters_)
                                                     : result;
}

}  // namespace cloud_preprocess
