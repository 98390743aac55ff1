// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "path/number_text.h"
#include "path/pose_convention.h"
#include "path/pose_names.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "tool_paths/tool_path_files.h"
#include "yaml/pose_fields.h"
#include "yaml/pose_lists.h"
#include "yaml/yaml_documents.h"
#include "yaml/yaml_shape.h"

namespace tool_paths {
namespace {

using scan_cell_common::excerpt;
using scan_cell_common::parse_number;
using scan_cell_common::UnusableInput;

class Reader {
 public:
  Reader(const std::string& source, const PathConventions& conventions)
      : source_(source), conventions_(conventions) {}

  ToolPathFile read(std::vector<YAML::Node> documents) {
    const auto is_empty = [](const YAML::Node& node) { return !node || node.IsNull(); };
    documents.erase(std::remove_if(documents.begin(), documents.end(), is_empty), documents.end());
    if (documents.empty()) documents.emplace_back();
    read_names(documents);
    PoseLists found = pose_lists_of(documents, source_);
    const std::vector<PoseList>& lists = found.lists;
    const std::vector<std::string> named = file_.path.process_names;
    const PoseSplitter splitter(source_, named, conventions_.process_values);
    understand_poses(splitter.split(lists[0].poses[0]), lists[0].poses[0]);
    std::set<std::string> kept = std::move(found.kept);
    for (const PoseList& list : lists) {
      Segment segment{list.name, {}};
      for (const YAML::Node& pose : list.poses) {
        const PoseParts parts = splitter.split(pose);
        segment.waypoints.push_back(waypoint_of(parts, pose));
        kept.insert(parts.kept.begin(), parts.kept.end());
      }
      if (file_.layout.pose.orientation == OrientationKind::kToolVector) carry_spin_along(segment);
      file_.path.segments.push_back(std::move(segment));
    }
    check_angles(file_.layout.pose, angles_, source_);
    shape_.documents = std::move(documents);
    file_.layout.kept.assign(kept.begin(), kept.end());
    file_.layout.yaml = std::make_shared<const YamlShape>(std::move(shape_));
    return std::move(file_);
  }

 private:
  std::string where(const YAML::Node& node) const { return line_of(source_, node.Mark()); }

  /// Reads the names of the path and its process values from the roots.
  void read_names(const std::vector<YAML::Node>& documents) {
    ToolPath& path = file_.path;
    path.name = source_;
    for (const YAML::Node& root : documents) {
      if (!root.IsMap()) continue;
      const YAML::Node name = root["name"];
      if (path.name == source_ && name && name.IsScalar()) path.name = name.Scalar();
      const YAML::Node list = root["process_names"];
      if (!list) continue;
      if (!list.IsSequence()) {
        throw UnusableInput(where(list), "process_names is not a list", "give a list of names");
      }
      std::vector<std::string> names;
      for (const YAML::Node& each : list) {
        if (!each.IsScalar()) throw UnusableInput(where(each), "not text", "give text");
        names.push_back(each.Scalar());
      }
      if (!path.process_names.empty() && names != path.process_names) {
        throw UnusableInput(where(list), "other process_names than in the document before",
                            "give all documents the same");
      }
      path.process_names = names;
    }
  }

  /// Determines the meaning of the numbers from the first pose. All others must be like it.
  void understand_poses(const PoseParts& first, const YAML::Node& node) {
    PathConventions conventions = conventions_;
    std::vector<std::string>& declared = conventions.process_values;
    for (const std::string& kept : first.kept)
      declared.erase(std::remove(declared.begin(), declared.end(), kept), declared.end());
    shape_.fields = first.fields;
    std::vector<std::string> names;
    for (const PoseField& field : first.fields) {
      names.push_back(field.name);
      if (is_process_value(field)) declared.push_back(field.name);
    }
    std::set<std::string> seen;
    for (const std::string& name : names)
      refuse_if_known(name, seen, node);
    const PoseNames found = understand(names, conventions, where(node));
    file_.layout.pose = found.convention;
    file_.path.has_orientation = found.convention.orientation != OrientationKind::kNone;
    shape_.places.assign(names.size(), 0);
    std::size_t next = 0;
    for (const std::size_t i : found.position)
      shape_.places[i] = next++;
    for (const std::size_t i : found.orientation)
      shape_.places[i] = next++;
    place_process_values(found.process, next);
    for (std::size_t i = 0; i < first.fields.size(); ++i)
      index_[first.fields[i].slot] = i;
  }

  static bool is_process_value(const PoseField& field) {
    return field.slot.find("process_values.") != std::string::npos;
  }

  void refuse_if_known(const std::string& name, std::set<std::string>& seen,
                       const YAML::Node& node) const {
    if (seen.insert(name).second) return;
    throw UnusableInput(where(node), fmt::format("'{}' occurs twice", excerpt(name)), "keep one");
  }

  /// Those in process_names come first, then the other numbers of the poses.
  void place_process_values(const std::vector<std::size_t>& process, std::size_t next) {
    for (const bool named : {true, false}) {
      for (const std::size_t i : process) {
        if (is_process_value(shape_.fields[i]) != named) continue;
        shape_.places[i] = next++;
        if (!named) file_.path.process_names.push_back(shape_.fields[i].name);
      }
    }
  }

  double number(const YAML::Node& node, const std::string& name) const {
    const std::optional<double> value =
        node.IsScalar() ? parse_number(node.Scalar()) : std::nullopt;
    if (!value || !std::isfinite(*value)) {
      const std::string text = node.IsScalar() ? excerpt(node.Scalar()) : "...";
      throw UnusableInput(where(node), fmt::format("{} = '{}'", excerpt(name), text),
                          "give a finite number");
    }
    return *value;
  }

  Waypoint waypoint_of(const PoseParts& parts, const YAML::Node& node) {
    refuse_other_fields(parts, node);
    std::vector<double> numbers(shape_.fields.size());
    for (std::size_t i = 0; i < parts.fields.size(); ++i) {
      const std::size_t field = index_.at(parts.fields[i].slot);
      numbers[shape_.places[field]] = number(parts.values[i], parts.fields[i].name);
    }
    const PoseConvention& convention = file_.layout.pose;
    const auto pose_end = numbers.begin() + static_cast<std::ptrdiff_t>(number_count(convention));
    const std::vector<double> pose(numbers.begin(), pose_end);
    if (convention.degrees) angles_.insert(angles_.end(), pose.begin() + 3, pose.end());
    Waypoint waypoint;
    waypoint.pose = pose_from(convention, pose, where(node));
    waypoint.process_values.assign(pose_end, numbers.end());
    return waypoint;
  }

  /// All poses must have the same numbers as the first.
  void refuse_other_fields(const PoseParts& parts, const YAML::Node& node) const {
    const auto refuse = [&](const PoseField& field) {
      const bool turned = field.slot.find("orientation") != std::string::npos ||
                          (field.name.size() == 2 && field.name[0] == 'q');
      throw UnusableInput(where(node),
                          turned ? "only some poses have an orientation"
                                 : fmt::format("only some poses have '{}'", excerpt(field.name)),
                          "give it in all poses or in none");
    };
    std::set<std::string> there;
    for (const PoseField& field : parts.fields) {
      if (index_.count(field.slot) == 0) refuse(field);
      refuse_if_known(field.slot, there, node);
    }
    if (there.size() == shape_.fields.size()) return;
    for (const PoseField& field : shape_.fields) {
      if (there.count(field.slot) == 0) refuse(field);
    }
  }

  const std::string& source_;
  const PathConventions& conventions_;
  ToolPathFile file_;
  YamlShape shape_;
  std::map<std::string, std::size_t> index_;  // field index of a slot
  std::vector<double> angles_;                // [degrees] of all waypoints
};

}  // namespace

ToolPathFile parse_tool_path_yaml(const std::string& text, const std::string& source,
                                  const PathConventions& conventions) {
  try {
    return Reader(source, conventions).read(load_documents(text, source));
  } catch (const YAML::Exception& error) {
    throw UnusableInput(line_of(source, error.mark), error.msg, "correct the YAML");
  }
}

}  // namespace tool_paths
