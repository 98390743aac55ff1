// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace tool_paths {

/// A number of a pose in YAML.
struct PoseField {
  std::string slot;  //!< the way to it within the pose: position.x, rpy.0, 3
  std::string name;  //!< as a column would be named: x, roll, qx
};

/// The documents a tool path came from, and where in their poses its numbers stand.
struct YamlShape {
  std::vector<YAML::Node> documents;  //!< those that are not empty
  std::vector<PoseField> fields;      //!< alike in all poses
  std::vector<std::size_t> places;  //!< of each field: among position, orientation, process values
};

/// A map with a position, or with x, y and z, or a list of three numbers and more; or a map that
/// holds such a map as its `pose`.
bool is_pose(const YAML::Node& node);

/// Whether all documents are a pose each.
bool is_stream_of_poses(const std::vector<YAML::Node>& documents);

/// Whether this is a list of poses: a segment. Lists are found by going through maps and lists in
/// their order, and not into poses.
bool is_pose_list(const YAML::Node& node);

}  // namespace tool_paths
