// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <map>

#include "path/number_text.h"
#include "path/pose_convention.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "tool_paths/tool_path_files.h"
#include "yaml/yaml_shape.h"

namespace tool_paths {
namespace {

using scan_cell_common::UnusableInput;

/// Position, orientation and process values, as the file's numbers.
std::vector<double> all_numbers(const PoseConvention& convention, const Waypoint& waypoint,
                                const Eigen::Quaterniond& rotation) {
  std::vector<double> numbers = numbers_of(convention, waypoint.pose.translation(), rotation);
  numbers.insert(numbers.end(), waypoint.process_values.begin(), waypoint.process_values.end());
  return numbers;
}

/// Writes documents as they were read, except for the numbers of their poses.
class ShapeWriter {
 public:
  ShapeWriter(const ToolPath& path, const PoseConvention& convention, const YamlShape& shape)
      : path_(path), convention_(convention), shape_(shape) {
    for (std::size_t i = 0; i < shape.fields.size(); ++i)
      places_[shape.fields[i].slot] = shape.places[i];
  }

  std::string write() {
    std::vector<YAML::Node> documents = shape_.documents;
    if (is_stream_of_poses(documents)) {
      write_poses(documents, [this] { begin_document(); });
    } else {
      for (const YAML::Node& document : documents) {
        begin_document();
        write(document);
      }
    }
    if (next_ != path_.segments.size()) refuse();
    return std::string(out_.c_str()) + "\n";
  }

 private:
  [[noreturn]] void refuse() const {
    throw UnusableInput("tool path '" + path_.name + "'",
                        fmt::format("{} segments do not fit the layout of another YAML file",
                                    path_.segments.size()),
                        "write it in the layout of its own file, or as a new file");
  }

  void begin_document() {
    if (begun_) out_ << YAML::BeginDoc;
    begun_ = true;
  }

  void write_style(const YAML::Node& node) {
    if (node.Style() == YAML::EmitterStyle::Flow) out_ << YAML::Flow;
    if (node.Style() == YAML::EmitterStyle::Block) out_ << YAML::Block;
  }

  void write(const YAML::Node& node) {
    if (is_pose_list(node)) {
      write_style(node);
      out_ << YAML::BeginSeq;
      write_poses(std::vector<YAML::Node>(node.begin(), node.end()), [] {});
      out_ << YAML::EndSeq;
      return;
    }
    write_other(node, [this](const YAML::Node& child, const std::string&) { write(child); });
  }

  /// @param write_child writes an element or value, given its index or key
  template <class WriteChild>
  void write_other(const YAML::Node& node, const WriteChild& write_child) {
    if (node.IsMap()) {
      write_style(node);
      out_ << YAML::BeginMap;
      for (const auto& entry : node) {
        out_ << YAML::Key;
        write_scalar(entry.first);
        out_ << YAML::Value;
        write_child(entry.second, entry.first.Scalar());
      }
      out_ << YAML::EndMap;
    } else if (node.IsSequence()) {
      write_style(node);
      out_ << YAML::BeginSeq;
      for (std::size_t i = 0; i < node.size(); ++i)
        write_child(node[i], fmt::to_string(i));
      out_ << YAML::EndSeq;
    } else {
      write_scalar(node);
    }
  }

  void write_scalar(const YAML::Node& node) {
    if (!node.IsDefined() || node.IsNull()) {
      out_ << YAML::Null;
      return;
    }
    const std::string& tag = node.Tag();
    if (tag == "!") {  // was in quotes
      out_ << YAML::DoubleQuoted << node.Scalar();
      return;
    }
    if (!tag.empty() && tag != "?") out_ << YAML::VerbatimTag(tag);
    out_ << node.Scalar();
  }

  /// Writes the next segment's waypoints, each in the shape of a pose of the file: the
  /// corresponding one, or, if the path was resampled, the one at the same share of the segment.
  template <class Before>
  void write_poses(const std::vector<YAML::Node>& poses, const Before& before) {
    if (next_ == path_.segments.size()) refuse();
    const Segment& segment = path_.segments[next_++];
    const std::vector<Eigen::Quaterniond> rotations = continuous_quaternions(segment);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      before();
      numbers_ = all_numbers(convention_, segment.waypoints[i], rotations[i]);
      if (numbers_.size() != shape_.fields.size()) refuse();
      write_pose(poses[i * poses.size() / rotations.size()], "");
    }
  }

  void write_pose(const YAML::Node& node, const std::string& slot) {
    const auto place = places_.find(slot);
    if (place != places_.end()) return write_number(node, numbers_[place->second]);
    write_other(node, [&](const YAML::Node& child, const std::string& key) {
      write_pose(child, slot.empty() ? key : slot + "." + key);
    });
  }

  /// Writes an unchanged number as it was written before.
  void write_number(const YAML::Node& node, double number) {
    const auto before = scan_cell_common::parse_number(node.Scalar());
    out_ << (before && *before == number ? node.Scalar() : to_text(number));
  }

  const ToolPath& path_;
  const PoseConvention& convention_;
  const YamlShape& shape_;
  std::map<std::string, std::size_t> places_;  // index of a slot's number in a waypoint
  YAML::Emitter out_;
  std::vector<double> numbers_;
  std::size_t next_ = 0;  // segment
  bool begun_ = false;
};

bool is_nested(const PoseConvention& convention) {
  const std::array<std::string, 3> position = {"x", "y", "z"};
  const std::vector<std::string> quaternion = {"qx", "qy", "qz", "qw"};
  return convention.position == position &&
         (convention.names.empty() || convention.names == quaternion);
}

void write_position_and_orientation(YAML::Emitter& out, const std::vector<double>& numbers,
                                    bool has_orientation) {
  const auto write_map = [&](const char* key, const std::string& names, std::size_t first) {
    out << YAML::Key << key << YAML::Value << YAML::BeginMap;
    for (std::size_t i = 0; i < names.size(); ++i)
      out << YAML::Key << std::string(1, names[i]) << YAML::Value << to_text(numbers[first + i]);
    out << YAML::EndMap;
  };
  write_map("position", "xyz", 0);
  if (has_orientation) write_map("orientation", "xyzw", 3);
}

void write_new(YAML::Emitter& out, const Waypoint& waypoint, const Eigen::Quaterniond& rotation,
               const PoseConvention& convention) {
  const std::vector<double> numbers = numbers_of(convention, waypoint.pose.translation(), rotation);
  out << YAML::Flow << YAML::BeginMap;
  if (is_nested(convention)) {
    write_position_and_orientation(out, numbers, !convention.names.empty());
  } else {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      out << YAML::Key << (i < 3 ? convention.position[i] : convention.names[i - 3]) << YAML::Value
          << to_text(numbers[i]);
    }
  }
  if (!waypoint.process_values.empty()) {
    out << YAML::Key << "process_values" << YAML::Value << YAML::BeginSeq;
    for (const double value : waypoint.process_values)
      out << to_text(value);
    out << YAML::EndSeq;
  }
  out << YAML::EndMap;
}

/// A new file in our format.
std::string new_yaml(const ToolPath& path, const PoseConvention& convention) {
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
      write_new(out, segment.waypoints[i], rotations[i], convention);
    out << YAML::EndSeq << YAML::EndMap;
  }
  out << YAML::EndSeq << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace

std::string tool_path_to_yaml(const ToolPath& path, const PathLayout& layout) {
  const PoseConvention convention = convention_for(path, layout.pose);
  if (!layout.yaml) return new_yaml(path, convention);
  return ShapeWriter(path, convention, *layout.yaml).write();
}

}  // namespace tool_paths
