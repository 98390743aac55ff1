// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/yaml.h>

#include "number_text.h"
#include "scan_cell_common/errors.h"
#include "scan_cell_common/text.h"
#include "tool_path_stretcher/tool_path_files.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::excerpt;
using scan_cell_common::parse_number;
using scan_cell_common::UnusableInput;

/// Finds the pose arrays of a document wherever they are nested: each innermost list of poses is a
/// segment. A pose is a map with `position`, or a list of 3 or 7 numbers.
class Reader {
 public:
  explicit Reader(const std::string& source) : source_(source) {}

  ToolPath read(const YAML::Node& root) {
    path_.name = source_;
    if (root.IsMap()) {
      if (const YAML::Node name = root["name"]; name && name.IsScalar()) {
        path_.name = name.Scalar();
      }
      if (const YAML::Node names = root["process_names"]; names && names.IsSequence()) {
        for (const YAML::Node& name : names)
          path_.process_names.push_back(text(name));
      }
    }
    visit(root, "", 0);
    if (path_.segments.empty()) {
      throw UnusableInput(source_, "no poses found",
                          "give lists of poses with position and orientation");
    }
    return std::move(path_);
  }

 private:
  std::string where(const YAML::Node& node) const {
    return source_ + ", line " + std::to_string(node.Mark().line + 1);
  }

  std::string text(const YAML::Node& node) const {
    if (!node.IsScalar()) throw UnusableInput(where(node), "not a text", "give a text");
    return node.Scalar();
  }

  double number(const YAML::Node& node, const YAML::Node& parent, const std::string& name) const {
    if (!node) throw UnusableInput(where(parent), "no '" + name + "'", "add it");
    const std::optional<double> value =
        node.IsScalar() ? parse_number(node.Scalar()) : std::nullopt;
    if (!value || !std::isfinite(*value)) {
      throw UnusableInput(where(node),
                          name + " = '" + (node.IsScalar() ? excerpt(node.Scalar()) : "...") + "'",
                          "give a finite number");
    }
    return *value;
  }

  static bool is_number_list(const YAML::Node& node) {
    if (!node.IsSequence() || node.size() == 0) return false;
    for (const YAML::Node& element : node) {
      if (!element.IsScalar()) return false;
    }
    return true;
  }

  static bool is_pose_map(const YAML::Node& node) { return node.IsMap() && node["position"]; }

  static bool is_pose(const YAML::Node& node) {
    return is_pose_map(node) || (is_number_list(node) && node.size() >= 3);
  }

  /// An alias can make a small text stand for an endless one.
  void count_visit(const YAML::Node& node) {
    constexpr std::size_t kMostNodes = 3000000;
    if (++visited_ > kMostNodes) {
      throw UnusableInput(where(node), "more than 3 million entries", "give a shorter path");
    }
  }

  /// @param depth an alias within what it stands for has no end
  void visit(const YAML::Node& node, const std::string& name, int depth) {
    constexpr int kDeepest = 64;
    if (depth > kDeepest) {
      throw UnusableInput(where(node), "nested more than 64 deep", "give a flatter path");
    }
    count_visit(node);
    if (node.IsMap()) {
      const YAML::Node own_name = node["name"];
      const std::string below = own_name && own_name.IsScalar() ? own_name.Scalar() : "";
      for (const auto& entry : node)
        visit(entry.second, below, depth + 1);
    } else if (node.IsSequence() && node.size() > 0) {
      if (is_pose(node[0])) {
        read_segment(node, name);
      } else {
        visit_elements(node, name, depth);
      }
    }
  }

  void visit_elements(const YAML::Node& node, const std::string& name, int depth) {
    for (const YAML::Node& element : node) {
      if (is_pose(element)) {
        throw UnusableInput(where(element), "a pose in a list that does not begin with one",
                            "give poses in lists of their own");
      }
      visit(element, name, depth + 1);
    }
  }

  void read_segment(const YAML::Node& node, const std::string& name) {
    Segment segment;
    segment.name = name;
    for (const YAML::Node& element : node) {
      count_visit(element);
      segment.waypoints.push_back(is_pose_map(element) ? from_map(element) : from_list(element));
    }
    path_.segments.push_back(std::move(segment));
  }

  Waypoint from_map(const YAML::Node& node) {
    Waypoint waypoint;
    const YAML::Node position = node["position"];
    const YAML::Node orientation = node["orientation"];
    if (!position.IsMap()) {
      throw UnusableInput(where(position), "position is not a map", "give x, y and z");
    }
    waypoint.pose.translation() =
        Eigen::Vector3d(number(position["x"], position, "x"), number(position["y"], position, "y"),
                        number(position["z"], position, "z"));
    note_orientation(static_cast<bool>(orientation), node);
    if (orientation) {
      if (!orientation.IsMap()) {
        throw UnusableInput(where(orientation), "orientation is not a map", "give x, y, z and w");
      }
      const Eigen::Vector4d xyzw(
          number(orientation["x"], orientation, "x"), number(orientation["y"], orientation, "y"),
          number(orientation["z"], orientation, "z"), number(orientation["w"], orientation, "w"));
      waypoint.pose.linear() = rotation_from(xyzw, where(orientation));
    }
    const YAML::Node values = node["process_values"];
    if (values && values.IsSequence()) {
      for (const YAML::Node& value : values)
        waypoint.process_values.push_back(number(value, node, "process value"));
    }
    if (waypoint.process_values.size() != path_.process_names.size()) {
      throw UnusableInput(where(node),
                          std::to_string(waypoint.process_values.size()) + " process_values for " +
                              std::to_string(path_.process_names.size()) + " process_names",
                          "give each pose one value a name");
    }
    return waypoint;
  }

  Waypoint from_list(const YAML::Node& node) {
    if (!node.IsSequence() || (node.size() != 3 && node.size() != 7)) {
      throw UnusableInput(where(node), "not a pose",
                          "give x, y, z or x, y, z, qx, qy, qz, qw, or a map with position");
    }
    std::array<double, 7> values{};
    for (std::size_t i = 0; i < node.size(); ++i)
      values[i] = number(node[i], node, "element " + std::to_string(i));
    Waypoint waypoint;
    waypoint.pose.translation() << values[0], values[1], values[2];
    note_orientation(node.size() == 7, node);
    if (node.size() == 7) {
      waypoint.pose.linear() =
          rotation_from({values[3], values[4], values[5], values[6]}, where(node));
    }
    if (!path_.process_names.empty()) {
      throw UnusableInput(where(node), "a pose without process_values",
                          "write poses with process values as maps");
    }
    return waypoint;
  }

  void note_orientation(bool has_orientation, const YAML::Node& node) {
    const bool first = path_.segments.empty() && !seen_pose_;
    if (first) path_.has_orientation = has_orientation;
    seen_pose_ = true;
    if (has_orientation != path_.has_orientation) {
      throw UnusableInput(where(node), "only some poses have an orientation",
                          "give all or none one");
    }
  }

  std::string source_;
  ToolPath path_;
  bool seen_pose_ = false;
  std::size_t visited_ = 0;
};

void write(YAML::Emitter& out, const Waypoint& waypoint, const Eigen::Quaterniond* rotation) {
  const Eigen::Vector3d at = waypoint.pose.translation();
  out << YAML::Flow << YAML::BeginMap << YAML::Key << "position" << YAML::Value << YAML::BeginMap;
  out << YAML::Key << "x" << YAML::Value << to_text(at.x());
  out << YAML::Key << "y" << YAML::Value << to_text(at.y());
  out << YAML::Key << "z" << YAML::Value << to_text(at.z()) << YAML::EndMap;
  if (rotation != nullptr) {
    out << YAML::Key << "orientation" << YAML::Value << YAML::BeginMap;
    out << YAML::Key << "x" << YAML::Value << to_text(rotation->x());
    out << YAML::Key << "y" << YAML::Value << to_text(rotation->y());
    out << YAML::Key << "z" << YAML::Value << to_text(rotation->z());
    out << YAML::Key << "w" << YAML::Value << to_text(rotation->w()) << YAML::EndMap;
  }
  if (!waypoint.process_values.empty()) {
    out << YAML::Key << "process_values" << YAML::Value << YAML::BeginSeq;
    for (const double value : waypoint.process_values)
      out << to_text(value);
    out << YAML::EndSeq;
  }
  out << YAML::EndMap;
}

}  // namespace

ToolPath parse_tool_path_yaml(const std::string& text, const std::string& source) {
  YAML::Node root;
  try {
    root = YAML::Load(text);
    return Reader(source).read(root);
  } catch (const YAML::Exception& error) {
    throw UnusableInput(source + ", line " + std::to_string(error.mark.line + 1), error.msg,
                        "correct the YAML");
  }
}

std::string tool_path_to_yaml(const ToolPath& path) {
  YAML::Emitter out;
  out << YAML::BeginMap << YAML::Key << "name" << YAML::Value << YAML::DoubleQuoted << path.name;
  out << YAML::Key << "process_names" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const std::string& name : path.process_names)
    out << YAML::DoubleQuoted << name;
  out << YAML::EndSeq << YAML::Key << "segments" << YAML::Value << YAML::BeginSeq;
  for (const Segment& segment : path.segments) {
    const std::vector<Eigen::Quaterniond> rotations = continuous_quaternions(segment);
    out << YAML::BeginMap << YAML::Key << "name" << YAML::Value << YAML::DoubleQuoted
        << segment.name << YAML::Key << "poses" << YAML::Value << YAML::BeginSeq;
    for (std::size_t i = 0; i < rotations.size(); ++i)
      write(out, segment.waypoints[i], path.has_orientation ? &rotations[i] : nullptr);
    out << YAML::EndSeq << YAML::EndMap;
  }
  out << YAML::EndSeq << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace tool_path_stretcher
