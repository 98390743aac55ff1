// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "yaml/yaml_shape.h"

#include <algorithm>
#include <set>

#include "path/name_parts.h"

namespace tool_paths {
namespace {

bool is_number_list(const YAML::Node& node) {
  if (!node.IsSequence() || node.size() == 0) return false;
  return std::all_of(node.begin(), node.end(),
                     [](const YAML::Node& element) { return element.IsScalar(); });
}

/// Whether x, y and z are among its keys, with or without a unit.
bool has_position_keys(const YAML::Node& map) {
  std::set<std::string> axes;
  for (const auto& entry : map) {
    if (!entry.first.IsScalar() || !entry.second.IsScalar()) continue;
    const NameParts parts = parts_of(entry.first.Scalar());
    const bool position = parts.unit.empty() || is_length_unit(parts.unit);
    if (position && parts.base.size() == 1) axes.insert(parts.base);
  }
  return axes.count("x") > 0 && axes.count("y") > 0 && axes.count("z") > 0;
}

bool is_bare_pose(const YAML::Node& node) {
  return node.IsMap() && (node["position"] || has_position_keys(node));
}

}  // namespace

bool is_pose(const YAML::Node& node) {
  if (is_bare_pose(node)) return true;
  if (node.IsMap()) return node["pose"] && is_bare_pose(node["pose"]);
  constexpr std::size_t kLeast = 3;
  return is_number_list(node) && node.size() >= kLeast;
}

bool is_stream_of_poses(const std::vector<YAML::Node>& documents) {
  return !documents.empty() &&
         std::all_of(documents.begin(), documents.end(), [](const YAML::Node& document) {
           return document.IsMap() && is_pose(document);
         });
}

bool is_pose_list(const YAML::Node& node) {
  return node.IsSequence() && node.size() > 0 && is_pose(node[0]);
}

}  // namespace tool_paths
