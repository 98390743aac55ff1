// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace scan_cell {

/// Commands of the ViDeE protocol (thesis, table 4), and WAIT_SCAN, which is ours.
enum class VideeCommandKind {
  kInitCycle,
  kInitCalibration,
  kPerformCalibration,
  kGrabImage,
  kSetPosition,
  kStartScan,
  kStopScan,
  kWaitScan,
  kReset,
};

/// One command as received. docs/videe_protocol.md describes the lines.
struct VideeCommand {
  VideeCommandKind kind = VideeCommandKind::kReset;  //!< which command
  std::vector<Eigen::Isometry3d>
      poses;  //!< SET_POSITION: of the flange [m], start and end of each pass
};

/// @param line without its line end
/// @throw scan_cell_common::ProtocolError if it is not a command, or its arguments are invalid
VideeCommand parse_videe(const std::string& line);

/// Pose from "x,y,z,rx,ry,rz": millimetres, and degrees about the fixed axes x, then y, then z.
/// @throw scan_cell_common::ProtocolError if it is not six numbers within a million
Eigen::Isometry3d pose_from_wire(const std::string& text);

/// The reverse. ry is from -90 to 90 degrees; at these ends rx is 0.
std::string pose_to_wire(const Eigen::Isometry3d& pose);

}  // namespace scan_cell
