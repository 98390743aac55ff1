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

/// The process value that marks manual changes: 1 if changed, else 0.
constexpr const char* kEditedValue = "edited";

/// Waypoints from first to last, inclusive, counted over all segments from 0.
struct WaypointRange {
  std::size_t first = 0;  //!< number of the first one
  std::size_t last = 0;   //!< at least `first`
};

/// Frame of the direction of a move or rotation.
enum class EditFrame {
  kTool,  //!< each waypoint's tool frame, as it is
  kPath,
};

/// Shifts waypoints.
struct MoveEdit {
  WaypointRange waypoints;                       //!< that it is done to
  Eigen::Vector3d by = Eigen::Vector3d::Zero();  //!< [m]
  EditFrame frame = EditFrame::kTool;            //!< of `by`
};

/// Rotates waypoints in place.
struct TurnEdit {
  WaypointRange waypoints;                           //!< that it is done to
  Eigen::Vector3d about = Eigen::Vector3d::UnitZ();  //!< unit length
  double angle = 0;                                  //!< [rad]
  EditFrame frame = EditFrame::kTool;                //!< of `about`
};

/// Removes waypoints. A segment that loses all of its waypoints is removed too.
struct DeleteEdit {
  WaypointRange waypoints;  //!< that it is done to
};

/// Adds a waypoint between one waypoint and the next of its segment; after the last one, at its
/// position.
struct AddEdit {
  std::size_t after = 0;  //!< number of the waypoint before
  double share = 0.5;     //!< position between the two, 0 to 1
};

/// Sets process values of waypoints.
struct SetEdit {
  WaypointRange waypoints;               //!< that it is done to
  std::map<std::string, double> values;  //!< by name
};

/// One manual change. Its waypoint numbers refer to the path after the edits before it.
using PathEdit = std::variant<MoveEdit, TurnEdit, DeleteEdit, AddEdit, SetEdit>;

/// The origin of a waypoint of an edited path.
struct WaypointOrigin {
  std::size_t first = 0;   //!< number before the edits; if added: of the one before it
  std::size_t second = 0;  //!< the same number; if added: of the one after it
  bool edited = false;     //!< moved, turned, added, or given a value
  bool added = false;      //!< added by an edit
};

/// A path after the edits, with the origin of each waypoint, over all segments.
struct EditedPath {
  ToolPath path;                        //!< [m]
  std::vector<WaypointOrigin> origins;  //!< in the order of the waypoints
};

/// Applies the edits one after the other.
/// @throw scan_cell_common::UnusableInput naming the edit, from 1, that cannot be applied: no such
/// waypoint, a rotation of a path without orientations, a process value that not all waypoints
/// would have, no waypoint left
EditedPath edited(const ToolPath& path, const std::vector<PathEdit>& edits);

/// The path with the process value kEditedValue; earlier marks are kept.
ToolPath marked(const EditedPath& edited);

/// The layout of the file that the path came from, extended by process values that it did not have.
/// In that case YAML is written as a new file, without its other keys.
PathLayout layout_for(const ToolPath& edited, PathLayout layout);

/// The edit in words, with millimetres and degrees: "waypoints 3 to 5 moved by 0, 0, -2 mm (tool)".
std::string to_string(const PathEdit& edit);

/// Reads the list `edits` of a YAML text (docs/editing_a_path.md).
/// @param name names the text in errors
/// @throw scan_cell_common::FileError if it is not YAML
/// @throw scan_cell_common::UnusableInput naming line and entry of anything missing, unknown or
/// senseless
std::vector<PathEdit> parse_path_edits(const std::string& text, const std::string& name);

/// The same for a file.
std::vector<PathEdit> load_path_edits(const std::string& path);

/// Text that parse_path_edits() reads back to the last digit.
std::string to_yaml(const std::vector<PathEdit>& edits);

}  // namespace tool_paths
