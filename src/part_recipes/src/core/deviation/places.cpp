// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "deviation/places.h"

#include <cmath>
#include <set>

#include "deviation/statistics.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/geometry/point_tree.h"

namespace part_recipes {

using scan_cell_common::PointTree;
using scan_cell_common::YamlEntry;

std::vector<Place> load_places(const std::string& file) {
  std::vector<Place> places;
  std::set<std::string> names;
  const YamlEntry root = YamlEntry::load(file);
  if (root.is_null()) return places;
  for (const YamlEntry& entry : root.elements()) {
    entry.refuse_unknown({"name", "position", "radius"});
    Place place;
    place.name = entry["name"].as<std::string>();
    if (!names.insert(place.name).second)
      entry["name"].refuse("'" + place.name + "' appears twice", "give each place its own name");
    place.position = entry["position"].vector<3>();
    if (entry.has("radius")) place.radius = entry["radius"].as<double>();
    if (!(place.radius > 0) || !std::isfinite(place.radius))
      entry["radius"].refuse(std::to_string(place.radius), "give metres above 0");
    places.push_back(place);
  }
  return places;
}

std::vector<PlaceDeviation> at_places(const std::vector<Place>& places,
                                      const tool_path_stretcher::Similarity& similarity,
                                      const Points& object, const std::vector<double>& deviations) {
  constexpr std::size_t kFewest =
      5;  // points, for a median that one loose point cannot move; chosen
  const PointTree tree(object);
  std::vector<PlaceDeviation> result;
  for (const Place& place : places) {
    const Eigen::Vector3d at = similarity * place.position;
    std::vector<std::pair<PointTree::Index, double>> found;
    tree.within(at.data(), place.radius * place.radius, found);
    std::vector<double> values;
    for (const auto& [index, squared] : found) {
      if (std::isfinite(deviations[index])) values.push_back(deviations[index]);
    }
    PlaceDeviation measured{place, std::nullopt, values.size()};
    if (values.size() >= kFewest) measured.deviation = median_of(std::move(values));
    result.push_back(std::move(measured));
  }
  return result;
}

}  // namespace part_recipes
