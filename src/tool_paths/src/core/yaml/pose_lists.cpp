// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "yaml/pose_lists.h"

#include <fmt/format.h>

#include "scan_cell_common/errors/errors.h"
#include "yaml/yaml_documents.h"
#include "yaml/yaml_shape.h"

namespace tool_paths {
namespace {

using scan_cell_common::UnusableInput;

/// Finds the lists of poses in documents at any depth.
class Finder {
 public:
  explicit Finder(const std::string& source) : source_(source) {}

  PoseLists find(const std::vector<YAML::Node>& documents) {
    if (is_stream_of_poses(documents)) {
      found_.lists.push_back({"", documents});
      return std::move(found_);
    }
    for (std::size_t i = 0; i < documents.size(); ++i) {
      const std::size_t before = found_.lists.size();
      visit(documents[i], "", 0);
      if (found_.lists.size() > before) continue;
      const bool only = documents.size() == 1;
      throw UnusableInput(only ? source_ : where(documents[i]),
                          only ? "no poses found" : "no poses found in this document",
                          "give lists of poses with position and orientation");
    }
    return std::move(found_);
  }

 private:
  std::string where(const YAML::Node& node) const { return line_of(source_, node.Mark()); }

  /// Limits the entries: an alias can make a small text expand endlessly.
  void count_visit(const YAML::Node& node) {
    constexpr std::size_t kMaxNodes = 3000000;  // chosen
    if (++visited_ > kMaxNodes) {
      throw UnusableInput(where(node), "more than 3 million entries", "give a shorter path");
    }
  }

  /// @param depth limited, because an alias may contain itself
  void visit(const YAML::Node& node, const std::string& name, int depth) {
    constexpr int kDeepest = 64;  // chosen
    if (depth > kDeepest) {
      throw UnusableInput(where(node), "nested more than 64 deep", "give a flatter path");
    }
    count_visit(node);
    if (node.IsMap()) {
      visit_map(node, depth);
    } else if (is_pose_list(node)) {
      found_.lists.push_back({name, {}});
      for (const YAML::Node& element : node) {
        count_visit(element);
        found_.lists.back().poses.push_back(element);
      }
    } else if (node.IsSequence()) {
      for (const YAML::Node& element : node) {
        refuse_pose(element);
        visit(element, name, depth + 1);
      }
    }
  }

  void visit_map(const YAML::Node& map, int depth) {
    const YAML::Node own_name = map["name"];
    const std::string below = own_name && own_name.IsScalar() ? own_name.Scalar() : "";
    const std::size_t at_first = found_.lists.size();
    std::set<std::string> beside;
    for (const auto& [key, value] : entries_of(map, source_)) {
      refuse_common_orientation(map, key, value);
      const std::size_t before = found_.lists.size();
      visit(value, below, depth + 1);
      const bool of_the_path = key == "name" || key == "process_names";
      if (!of_the_path && found_.lists.size() == before) beside.insert(key);
    }
    if (found_.lists.size() > at_first) found_.kept.insert(beside.begin(), beside.end());
  }

  void refuse_pose(const YAML::Node& element) const {
    if (is_pose(element)) {
      throw UnusableInput(where(element), "a pose in a list that does not begin with one",
                          "give poses in lists of their own");
    }
    if (!element.IsMap()) return;
    for (const char* const key : {"translation", "xyz", "point", "pos", "transform", "cartesian"}) {
      if (!element[key]) continue;
      throw UnusableInput(where(element), fmt::format("'{}' could be a position", key),
                          "give position {x, y, z}, or x, y and z");
    }
  }

  /// An orientation beside a list of poses may be meant for all of them.
  void refuse_common_orientation(const YAML::Node& map, const std::string& key,
                                 const YAML::Node& value) const {
    static const std::set<std::string> names = {"orientation", "rpy",      "quaternion",
                                                "euler",       "rotation", "normal"};
    if (names.count(key) == 0 || value.IsScalar() || value.IsNull() || map["position"]) return;
    throw UnusableInput(where(value),
                        fmt::format("'{}' beside the poses could be an orientation", key),
                        "give each pose its own");
  }

  const std::string& source_;
  PoseLists found_;
  std::size_t visited_ = 0;
};

}  // namespace

PoseLists pose_lists_of(const std::vector<YAML::Node>& documents, const std::string& source) {
  return Finder(source).find(documents);
}

}  // namespace tool_paths
