// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parts_finder.h"

#include <pluginlib/class_list_macros.hpp>

#include "tool_path_stretcher/parts_in_scan.h"

namespace tool_path_stretcher {

void PartsFinder::load(const std::string& file, double metres_per_unit) {
  reference_ = load_surface(file, parameters_.leaf, metres_per_unit);
}

cloud_preprocess::ReferenceSearch PartsFinder::find(
    const cloud_preprocess::Cloud& scene,
    const std::vector<std::vector<std::uint32_t>>& objects) const {
  std::vector<std::vector<std::size_t>> things;
  for (const std::vector<std::uint32_t>& object : objects)
    things.emplace_back(object.begin(), object.end());
  const PartsInScan parts =
      parts_in_scan(reference_.value(), to_points(scene), things, parameters_);
  cloud_preprocess::ReferenceSearch search{{}, parts.why_none};
  for (const FoundPart& part : parts.parts)
    search.found.push_back({to_cloud(part.laid), {part.explained.begin(), part.explained.end()}});
  return search;
}

}  // namespace tool_path_stretcher

PLUGINLIB_EXPORT_CLASS(tool_path_stretcher::PartsFinder, cloud_preprocess::ReferenceFinder)
