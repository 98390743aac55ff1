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
  /// Identity rotation where the path has none.
  Eigen::Isometry3d pose =
      Eigen::Isometry3d::Identity();   //!< identity rotation where the path has none
  std::vector<double> process_values;  //!< in the order of ToolPath::process_names
};

/// A run of waypoints in which the tool stays in contact.
struct Segment {
  std::string name;                 //!< as in the file
  std::vector<Waypoint> waypoints;  //!< in the order of the motion
};

/// A path of the tool. Order and count of segments and waypoints mean something and are kept.
struct ToolPath {
  std::string name;                        //!< as in the file
  bool has_orientation = false;            //!< false: the rotations are identity and mean nothing
  std::vector<std::string> process_names;  //!< of each waypoint's process values
  std::vector<Segment> segments;           //!< in the order of the motion
};

/// Where the waypoints lie [m], in their order.
Points positions_of(const Segment& segment);
Points positions_of(const ToolPath& path);  //!< of all segments

/// Of all segments.
std::size_t waypoint_count(const ToolPath& path);

/// @throw scan_cell_common::UnusableInput if the path has no waypoint, an empty segment, a waypoint
/// that is not finite, a rotation that is none, or process values that do not fit their names
void check(const ToolPath& path);

/// On the way from one waypoint to another: position and process values linearly, rotation the
/// short way.
/// @param share of the way, 0 to 1
Waypoint between(const Waypoint& from, const Waypoint& to, double share);

/// The path with waypoints at even steps of the arc length along each segment, at most `spacing`
/// [m] long; a segment's ends are kept, and so is a segment that has no length. Positions and
/// process values are interpolated linearly, rotations the short way.
/// @throw scan_cell_common::UnusableInput if that makes too many waypoints
ToolPath resampled(const ToolPath& path, double spacing);

/// The rotations of a segment as unit quaternions, each in the hemisphere of the one before, so
/// that what interpolates them goes the short way. The first has w >= 0.
std::vector<Eigen::Quaterniond> continuous_quaternions(const Segment& segment);

}  // namespace tool_paths
