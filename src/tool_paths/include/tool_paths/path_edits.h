// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "tool_paths/path_conventions.h"
#include "tool_paths/tool_path.h"

namespace tool_paths {

/// The process value that marks what a person changed: 1, else 0.
constexpr const char* kEditedValue = "edited";

/// Waypoints from the first to the last, both with it, counted over all segments from 0.
struct WaypointRange {
  std::size_t first = 0;  //!< its number
  std::size_t last = 0;   //!< not before the first
};

/// Of the direction of a move or a turn.
enum class EditFrame {
  kTool,  //!< of each waypoint as it is
  kPath,
};

/// Waypoints shifted.
struct MoveEdit {
  WaypointRange waypoints;                       //!< that it is done to
  Eigen::Vector3d by = Eigen::Vector3d::Zero();  //!< [m]
  EditFrame frame = EditFrame::kTool;            //!< of `by`
};

/// Waypoints turned where they are.
struct TurnEdit {
  WaypointRange waypoints;                           //!< that it is done to
  Eigen::Vector3d about = Eigen::Vector3d::UnitZ();  //!< of length 1
  double angle = 0;                                  //!< [rad]
  EditFrame frame = EditFrame::kTool;                //!< of `about`
};

/// Waypoints left out. A segment that loses all of its own goes with them.
struct DeleteEdit {
  WaypointRange waypoints;  //!< that it is done to
};

/// A waypoint put on the way from one to the next of its segment; after the last one, where that
/// is.
struct AddEdit {
  std::size_t after = 0;  //!< which waypoint
  double share = 0.5;     //!< of the way, 0 to 1
};

/// Process values given to waypoints.
struct SetEdit {
  WaypointRange waypoints;               //!< that it is done to
  std::map<std::string, double> values;  //!< by name
};

/// One change by hand. Its numbers are those of the path that the edits before it left.
using PathEdit = std::variant<MoveEdit, TurnEdit, DeleteEdit, AddEdit, SetEdit>;

/// Where a waypoint of an edited path comes from.
struct WaypointOrigin {
  std::size_t first = 0;   //!< its number before the edits; of one that was added, the one before
  std::size_t second = 0;  //!< the same number; of one that was added, the one after it
  bool edited = false;     //!< moved, turned, added, or given a value
  bool added = false;      //!< by an edit
};

/// A path after the edits, with the origin of each of its waypoints, over all segments.
struct EditedPath {
  ToolPath path;                        //!< [m]
  std::vector<WaypointOrigin> origins;  //!< in the order of the waypoints
};

/// Does the edits one after the other.
/// @throw scan_cell_common::UnusableInput naming the edit, from 1, that the path has no place for:
/// no such waypoint, a turn of a path without orientations, a process value that not all waypoints
/// would have, nothing left
EditedPath edited(const ToolPath& path, const std::vector<PathEdit>& edits);

/// The path with the process value kEditedValue; what was marked before stays marked.
ToolPath marked(const EditedPath& edited);

/// The layout of the file that the path came from, with room for process values that it did not
/// have. YAML is written as a new file then: what else stood in it has no place there.
PathLayout layout_for(const ToolPath& edited, PathLayout layout);

/// In words, with millimetres and degrees: "waypoints 3 to 5 moved by 0, 0, -2 mm (tool)".
std::string to_string(const PathEdit& edit);

/// Reads the list `edits` of a YAML text (docs/editing_a_path.md).
/// @param name of the text, in errors
/// @throw scan_cell_common::FileError if it is not YAML
/// @throw scan_cell_common::UnusableInput naming line and entry of what is missing, unknown or
/// makes no sense
std::vector<PathEdit> parse_path_edits(const std::string& text, const std::string& name);

/// The same of a file.
std::vector<PathEdit> load_path_edits(const std::string& path);

/// As parse_path_edits() reads it, to the last digit.
std::string to_yaml(const std::vector<PathEdit>& edits);

}  // namespace tool_paths
