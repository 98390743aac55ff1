// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

namespace tool_paths {

using Points = std::vector<Eigen::Vector3d>;  //!< [m]

/// One pose of the tool in the path's frame [m], with its process values.
struct Waypoint {
  /// Identity rotation if the path has no orientations.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::vector<double> process_values;  //!< in the order of ToolPath::process_names
};

/// A run of waypoints in which the tool stays in contact.
struct Segment {
  std::string name;                 //!< as in the file
  std::vector<Waypoint> waypoints;  //!< in the order of the motion
};

/// A path of the tool. The order and number of segments and waypoints are significant and are kept.
struct ToolPath {
  std::string name;                        //!< as in the file
  bool has_orientation = false;            //!< false: rotations are identity, without meaning
  std::vector<std::string> process_names;  //!< of each waypoint's process values
  std::vector<Segment> segments;           //!< in the order of the motion
};

/// The waypoints' positions [m], in order.
Points positions_of(const Segment& segment);
Points positions_of(const ToolPath& path);  //!< of all segments

/// Number of waypoints of all segments.
std::size_t waypoint_count(const ToolPath& path);

/// @throw scan_cell_common::UnusableInput if the path has no waypoint, an empty segment, a waypoint
/// that is not finite, an invalid rotation, or process values that do not match their names
void check(const ToolPath& path);

/// Interpolates between two waypoints: position and process values linearly, rotation along the
/// shorter arc.
/// @param share position between the two, 0 to 1
Waypoint between(const Waypoint& from, const Waypoint& to, double share);

/// The path with waypoints at even steps of arc length along each segment, at most `spacing` [m]
/// long. The ends of a segment and segments without length are kept. Positions and process values
/// are interpolated linearly, rotations along the shorter arc.
/// @throw scan_cell_common::UnusableInput if this makes too many waypoints
ToolPath resampled(const ToolPath& path, double spacing);

/// The rotations of a segment as unit quaternions, each in the hemisphere of the one before, so
/// that interpolation follows the shorter arc. The first has w >= 0.
std::vector<Eigen::Quaterniond> continuous_quaternions(const Segment& segment);

}  // namespace tool_paths
