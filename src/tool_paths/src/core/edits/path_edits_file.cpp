// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "scan_cell_common/files/yaml_file.h"
#include "tool_paths/path_edits.h"

namespace tool_paths {
namespace {

using scan_cell_common::yaml_list;
using scan_cell_common::YamlEntry;

std::size_t number_of(const YamlEntry& entry) {
  const auto number = entry.as<long long>();
  constexpr long long kMost = 1'000'000'000;  // beyond any path
  if (number < 0 || number > kMost)
    entry.refuse(fmt::to_string(number), "give the number of a waypoint, from 0");
  return static_cast<std::size_t>(number);
}

/// One number, or the first and last.
WaypointRange range_of(const YamlEntry& entry) {
  if (!entry.is_list()) return {number_of(entry), number_of(entry)};
  const std::vector<YamlEntry> ends = entry.elements();
  if (ends.size() != 2)
    entry.refuse(fmt::format("{} numbers", ends.size()), "give one number, or first and last");
  const WaypointRange range = {number_of(ends[0]), number_of(ends[1])};
  if (range.last < range.first)
    entry.refuse(fmt::format("{} to {}", range.first, range.last), "give the lower one first");
  return range;
}

EditFrame frame_of(const YamlEntry& edit) {
  if (!edit.has("frame")) return EditFrame::kTool;
  const auto name = edit["frame"].as<std::string>();
  if (name != "tool" && name != "path") edit["frame"].refuse(name, "give tool or path");
  return name == "tool" ? EditFrame::kTool : EditFrame::kPath;
}

double finite(const YamlEntry& entry) {
  const auto value = entry.as<double>();
  if (!std::isfinite(value)) entry.refuse(fmt::to_string(value), "give a finite number");
  return value;
}

MoveEdit read_move(const YamlEntry& edit) {
  edit.refuse_unknown({"waypoints", "by", "frame"});
  return {range_of(edit["waypoints"]), edit["by"].vector<3>(), frame_of(edit)};
}

TurnEdit read_turn(const YamlEntry& edit) {
  edit.refuse_unknown({"waypoints", "about", "angle", "frame"});
  return {range_of(edit["waypoints"]), edit["about"].direction(), finite(edit["angle"]),
          frame_of(edit)};
}

AddEdit read_add(const YamlEntry& edit) {
  edit.refuse_unknown({"after", "share"});
  AddEdit add;
  add.after = number_of(edit["after"]);
  if (edit.has("share")) add.share = finite(edit["share"]);
  if (add.share < 0 || add.share > 1)
    edit["share"].refuse(fmt::to_string(add.share), "give 0 to 1");
  return add;
}

SetEdit read_set(const YamlEntry& edit) {
  edit.refuse_unknown({"waypoints", "values"});
  SetEdit set;
  set.waypoints = range_of(edit["waypoints"]);
  for (const auto& [name, value] : edit["values"].entries())
    set.values[name] = finite(value);
  if (set.values.empty()) edit["values"].refuse("none", "give names with their values");
  return set;
}

PathEdit read_edit(const YamlEntry& entry) {
  entry.refuse_unknown({"move", "turn", "delete", "add", "set"});
  const auto edits = entry.entries();
  if (edits.size() != 1)
    entry.refuse(fmt::format("{} edits in one", edits.size()),
                 "give one of move, turn, delete, add and set");
  const auto& [name, edit] = edits.front();
  if (name == "move") return read_move(edit);
  if (name == "turn") return read_turn(edit);
  if (name == "add") return read_add(edit);
  if (name == "set") return read_set(edit);
  edit.refuse_unknown({"waypoints"});
  return DeleteEdit{range_of(edit["waypoints"])};
}

std::vector<PathEdit> read(const YamlEntry& root) {
  root.refuse_unknown({"edits"});
  std::vector<PathEdit> edits;
  for (const YamlEntry& entry : root["edits"].elements())
    edits.push_back(read_edit(entry));
  if (edits.empty()) root["edits"].refuse("empty", "give at least one edit");
  return edits;
}

YAML::Node node_of(const WaypointRange& range) {
  if (range.first == range.last) return YAML::Node(range.first);
  return yaml_list(
      Eigen::Vector2d(static_cast<double>(range.first), static_cast<double>(range.last)));
}

/// A map on one line, with the waypoints if the edit has some.
template <class Edit>
YAML::Node begin(const Edit& edit) {
  YAML::Node node;
  node.SetStyle(YAML::EmitterStyle::Flow);
  node["waypoints"] = node_of(edit.waypoints);
  return node;
}

void add_frame(YAML::Node& node, EditFrame frame) {
  if (frame == EditFrame::kPath) node["frame"] = "path";
}

struct Writer {
  YAML::Node all;

  void operator()(const MoveEdit& edit) {
    YAML::Node node = begin(edit);
    node["by"] = yaml_list(edit.by);
    add_frame(node, edit.frame);
    all["move"] = node;
  }
  void operator()(const TurnEdit& edit) {
    YAML::Node node = begin(edit);
    node["about"] = yaml_list(edit.about);
    node["angle"] = edit.angle;
    add_frame(node, edit.frame);
    all["turn"] = node;
  }
  void operator()(const DeleteEdit& edit) { all["delete"] = begin(edit); }
  void operator()(const AddEdit& edit) {
    YAML::Node node;
    node.SetStyle(YAML::EmitterStyle::Flow);
    node["after"] = edit.after;
    node["share"] = edit.share;
    all["add"] = node;
  }
  void operator()(const SetEdit& edit) {
    YAML::Node node = begin(edit);
    for (const auto& [name, value] : edit.values)
      node["values"][name] = value;
    all["set"] = node;
  }
};

}  // namespace

std::vector<PathEdit> parse_path_edits(const std::string& text, const std::string& name) {
  return read(YamlEntry::parse(text, name));
}

std::vector<PathEdit> load_path_edits(const std::string& path) {
  return read(YamlEntry::load(path));
}

std::string to_yaml(const std::vector<PathEdit>& edits) {
  YAML::Node root;
  root["edits"] = YAML::Node(YAML::NodeType::Sequence);
  for (const PathEdit& edit : edits) {
    Writer writer;
    std::visit(writer, edit);
    root["edits"].push_back(writer.all);
  }
  YAML::Emitter out;
  out << root;
  return std::string(out.c_str()) + "\n";
}

}  // namespace tool_paths
