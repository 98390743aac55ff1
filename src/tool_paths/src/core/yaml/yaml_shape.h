// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace tool_paths {

/// A number within a pose in YAML.
struct PoseField {
  std::string slot;  //!< path to it within the pose: position.x, rpy.0, 3
  std::string name;  //!< as a column name: x, roll, qx
};

/// The documents a tool path came from, and where its numbers are in their poses.
struct YamlShape {
  std::vector<YAML::Node> documents;  //!< non-empty ones
  std::vector<PoseField> fields;      //!< the same in all poses
  std::vector<std::size_t>
      places;  //!< of each field: index among position, orientation, process values
};

/// Whether this is a map with a position, or with x, y and z; a list of at least three numbers; or
/// a map with such a map as its `pose`.
bool is_pose(const YAML::Node& node);

/// Whether each document is a pose.
bool is_stream_of_poses(const std::vector<YAML::Node>& documents);

/// Whether this is a list of poses: a segment. Lists are found by traversing maps and lists in
/// order, but not poses.
bool is_pose_list(const YAML::Node& node);

}  // namespace tool_paths
