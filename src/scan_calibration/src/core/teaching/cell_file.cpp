// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "teaching/cell_file.h"

#include <filesystem>

#include "scan_cell_common/files/yaml_file.h"

namespace scan_calibration {
namespace {

using scan_cell_common::YamlEntry;

const char* const kBase = "base_link_in_world";
const char* const kTool = "tool_tip_in_tool0";

YamlEntry load(const std::string& path) {
  YamlEntry root = YamlEntry::load(path);
  root.refuse_unknown({kBase, kTool});
  return root;
}

void save(const std::string& path, const YAML::Node& root) {
  YAML::Emitter text;
  text << root;
  scan_cell_common::save_text(path,
                              "# Where things stand in the cell. Poses: translation [m], rotation "
                              "as a quaternion x y z w.\n" +
                                  std::string(text.c_str()) + "\n");
}

}  // namespace

Cell load_cell(const std::string& path) {
  const YamlEntry root = load(path);
  return {root[kBase].pose(), root[kTool].pose()};
}

void save_cell(const std::string& path, const Cell& cell) {
  YAML::Node root;
  root[kBase] = scan_cell_common::yaml_pose(cell.base_link_in_world);
  root[kTool] = scan_cell_common::yaml_pose(cell.tool_tip_in_tool0);
  save(path, root);
}

Eigen::Isometry3d load_cell_entry(const std::string& path, const std::string& entry) {
  return load(path)[entry].pose();
}

void update_cell_entry(const std::string& path, const std::string& entry,
                       const Eigen::Isometry3d& pose) {
  YAML::Node root;
  if (std::filesystem::exists(path)) {
    load(path);  // what cannot be read must not be lost
    root = scan_cell_common::load_yaml(path);
  }
  root[entry] = scan_cell_common::yaml_pose(pose);
  save(path, root);
}

}  // namespace scan_calibration
