// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "yaml/pose_fields.h"

#include <fmt/format.h>

#include <algorithm>

#include "path/pose_names.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "yaml/yaml_documents.h"

namespace tool_paths {
namespace {

using scan_cell_common::excerpt;
using scan_cell_common::UnusableInput;

bool is_number(const YAML::Node& node) {
  return node.IsScalar() && scan_cell_common::parse_number(node.Scalar()).has_value();
}

/// Numbers that are not finite, as YAML writes them: refused as numbers, not kept as text.
bool is_not_finite(const YAML::Node& node) {
  if (!node.IsScalar()) return false;
  const std::string text = scan_cell_common::lower_case(node.Scalar());
  return text == ".nan" || text == ".inf" || text == "-.inf" || text == "+.inf";
}

void add(const std::string& slot, const std::string& name, const YAML::Node& value,
         PoseParts& parts) {
  parts.fields.push_back({slot, name});
  parts.values.push_back(value);
}

}  // namespace

std::string PoseSplitter::where(const YAML::Node& node) const {
  return line_of(source_, node.Mark());
}

PoseParts PoseSplitter::split(const YAML::Node& node) const {
  PoseParts parts;
  if (node.IsMap()) {
    split_map(node, "", parts);
    const bool has_values =
        std::any_of(parts.fields.begin(), parts.fields.end(), [](const PoseField& field) {
          return field.slot.find("process_values.") != std::string::npos;
        });
    if (!has_values) check_value_count(node, 0);
  } else {
    split_list(node, parts);
  }
  return parts;
}

void PoseSplitter::split_map(const YAML::Node& map, const std::string& prefix,
                             PoseParts& parts) const {
  for (const auto& [key, value] : entries_of(map, source_))
    split_entry(key, value, prefix, parts);
}

void PoseSplitter::split_entry(const std::string& key, const YAML::Node& value,
                               const std::string& prefix, PoseParts& parts) const {
  const std::string slot = prefix + key;
  if (key == "position") {
    split_position(value, slot, parts);
  } else if (key == "orientation") {
    split_orientation(value, slot, parts);
  } else if (key == "rpy") {
    split_rpy(value, slot, parts);
  } else if (key == "process_values") {
    split_process_values(value, slot, parts);
  } else if (key == "pose" && value.IsMap() && prefix.empty()) {
    split_map(value, slot + ".", parts);
  } else if (is_number(value) || is_not_finite(value)) {
    add(slot, key, value, parts);
  } else {
    keep(key, value, parts);
  }
}

void PoseSplitter::split_position(const YAML::Node& node, const std::string& slot,
                                  PoseParts& parts) const {
  if (node.IsSequence()) return split_elements(node, slot, {"x", "y", "z"}, parts);
  if (!node.IsMap()) throw UnusableInput(where(node), "position is not a map", "give x, y and z");
  for (const char* const axis : {"x", "y", "z"}) {
    if (!node[axis]) throw UnusableInput(where(node), fmt::format("no '{}'", axis), "add it");
  }
  for (const auto& entry : node) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (key != "x" && key != "y" && key != "z") {
      throw UnusableInput(where(node), fmt::format("'{}' in a position", excerpt(key)),
                          "give x, y and z alone");
    }
    add(slot + "." + key, key, entry.second, parts);
  }
}

void PoseSplitter::split_orientation(const YAML::Node& node, const std::string& slot,
                                     PoseParts& parts) const {
  if (!node.IsMap()) {
    throw UnusableInput(where(node), "orientation is not a map", "give x, y, z and w");
  }
  const bool quaternion = node["w"] || node["x"] || node.size() == 0;
  if (quaternion) {
    for (const char* const part : {"x", "y", "z", "w"}) {
      if (!node[part]) throw UnusableInput(where(node), fmt::format("no '{}'", part), "add it");
    }
  }
  for (const auto& entry : node) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    const bool part = key == "x" || key == "y" || key == "z" || key == "w";
    const bool angle = key == "roll" || key == "pitch" || key == "yaw";
    if (quaternion ? !part : !angle) {
      throw UnusableInput(where(node), fmt::format("'{}' in an orientation", excerpt(key)),
                          "give x, y, z and w, or roll, pitch and yaw");
    }
    add(slot + "." + key, part ? "q" + key : key, entry.second, parts);
  }
}

void PoseSplitter::split_rpy(const YAML::Node& node, const std::string& slot,
                             PoseParts& parts) const {
  if (node.IsSequence()) return split_elements(node, slot, {"roll", "pitch", "yaw"}, parts);
  if (!node.IsMap()) {
    throw UnusableInput(where(node), "rpy is not a list", "give roll, pitch and yaw");
  }
  return split_orientation(node, slot, parts);
}

void PoseSplitter::check_value_count(const YAML::Node& node, std::size_t count) const {
  if (count == process_names_.size()) return;
  throw UnusableInput(
      where(node),
      fmt::format("{} process_values for {} process_names", count, process_names_.size()),
      "give each pose one value per name");
}

void PoseSplitter::split_process_values(const YAML::Node& node, const std::string& slot,
                                        PoseParts& parts) const {
  if (!node.IsSequence()) {
    throw UnusableInput(where(node), "process_values is not a list", "give one value per name");
  }
  check_value_count(node, node.size());
  split_elements(node, slot, process_names_, parts);
}

void PoseSplitter::split_list(const YAML::Node& node, PoseParts& parts) const {
  static const std::vector<std::string> names = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  if (!node.IsSequence() || (node.size() != 3 && node.size() != 7)) {
    throw UnusableInput(where(node), "not a pose",
                        "give x, y, z or x, y, z, qx, qy, qz, qw, or a map with position");
  }
  if (!process_names_.empty()) {
    throw UnusableInput(where(node), "a pose without process_values",
                        "write poses with process values as maps");
  }
  for (std::size_t i = 0; i < node.size(); ++i)
    add(fmt::to_string(i), names[i], node[i], parts);
}

void PoseSplitter::split_elements(const YAML::Node& list, const std::string& slot,
                                  const std::vector<std::string>& names, PoseParts& parts) const {
  if (list.size() != names.size()) {
    throw UnusableInput(where(list), fmt::format("{} numbers in {}", list.size(), excerpt(slot)),
                        fmt::format("give {}", names.size()));
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    add(fmt::format("{}.{}", slot, i), names[i], list[i], parts);
}

void PoseSplitter::keep(const std::string& key, const YAML::Node& value, PoseParts& parts) const {
  check_kept(key, value, 0);
  parts.kept.push_back(key);
}

void PoseSplitter::check_kept(const std::string& key, const YAML::Node& value, int depth) const {
  constexpr int kDeepest = 16;            // chosen
  constexpr std::size_t kMost = 3000000;  // an alias can make a small text endless; chosen
  if (++visited_ > kMost) {
    throw UnusableInput(where(value), "more than 3 million entries", "give a shorter path");
  }
  if (depth > kDeepest) {
    throw UnusableInput(where(value), "a pose nested more than 16 deep", "give flatter poses");
  }
  check_kept_name(key, value);
  if (is_pose_list(value)) {
    throw UnusableInput(where(value), "poses within a pose", "give poses in lists of their own");
  }
  if (value.IsMap()) {
    for (const auto& entry : value) {
      if (!entry.first.IsScalar()) {
        throw UnusableInput(where(value), "a key that is not text", "give keys as text");
      }
      check_kept(entry.first.Scalar(), entry.second, depth + 1);
    }
  } else if (value.IsSequence()) {
    for (const YAML::Node& element : value)
      check_kept("", element, depth + 1);
  }
}

void PoseSplitter::check_kept_name(const std::string& key, const YAML::Node& value) const {
  const auto& known = not_orientations_;
  if (std::find(known.begin(), known.end(), key) != known.end()) return;
  if (key == "<<") {
    throw UnusableInput(where(value), "'<<' merges keys", "write them out");
  }
  if (!could_be_orientation(key)) return;
  throw UnusableInput(where(value),
                      fmt::format("'{}' could be an orientation of an unknown kind", excerpt(key)),
                      "give orientation {x, y, z, w}, rpy, or numbers by name such as rx, ry, rz; "
                      "or say that it is not one (--process-values)");
}

}  // namespace tool_paths
