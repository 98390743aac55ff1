// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <set>
#include <string>
#include <vector>

namespace tool_paths {

/// The poses of a segment, as in the file.
struct PoseList {
  std::string name;
  std::vector<YAML::Node> poses;
};

struct PoseLists {
  std::vector<PoseList> lists;
  std::set<std::string> kept;  //!< other keys beside the lists
};

/// Finds the lists of poses in documents, wherever they are nested.
/// @throw scan_cell_common::UnusableInput if a document has none, or something that looks like
/// poses is not a list of poses
PoseLists pose_lists_of(const std::vector<YAML::Node>& documents, const std::string& source);

}  // namespace tool_paths
