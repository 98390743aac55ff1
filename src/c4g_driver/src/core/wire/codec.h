// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "c4g_driver/robot_state.h"
#include "c4g_driver/tool_motion.h"

/// Converts packets of c4g_protocol.md to text and back. Nothing here knows of sockets or time.
namespace c4g_driver {

constexpr int kProtocolVersion = 1;              //!< "c4g" of each packet, c4g_protocol.md
constexpr std::size_t kMaxDatagramBytes = 1400;  //!< c4g_protocol.md

struct Open {};
struct Close {};
struct MoveCartesian {
  Eigen::Isometry3d flange;
  double camera_rate;  //!< [Hz]
};
struct MoveCircular {
  Eigen::Isometry3d via;
  Eigen::Isometry3d flange;
  double camera_rate;  //!< [Hz]
};
struct MoveJoint {
  Joints joints;
  double camera_rate;  //!< [Hz]
};
struct LoadPath {
  std::uint64_t path;  //!< its number, above 0
  std::uint64_t size;  //!< waypoints
  Eigen::Isometry3d flange_to_tip;
};
struct PathPiece {
  std::uint64_t path;
  std::uint64_t first;  //!< number of its first waypoint, counted from 0
  std::vector<ToolWaypoint> waypoints;
};
struct FollowPath {
  std::uint64_t path;
  std::uint64_t from;      //!< waypoint
  std::uint32_t checksum;  //!< see PathChecksum
  double watch = 0.08;     //!< [s] of the client's silence that end the path
};
struct Stop {};
struct SetOverride {
  double override;  //!< [%]
};
struct SetLinearSpeed {
  double speed;  //!< [m/s]
};
struct GetStaticPose {};
struct GetParameter {
  std::string name;
};
struct SetParameter {
  std::string name;
  std::string value;  //!< JSON
};
struct SetDrives {
  bool on;
};
struct ResetAlarms {};

using Request = std::variant<Open, Close, MoveCartesian, MoveCircular, MoveJoint, LoadPath,
                             PathPiece, FollowPath, Stop, SetOverride, SetLinearSpeed,
                             GetStaticPose, GetParameter, SetParameter, SetDrives, ResetAlarms>;

/// The command's name on the wire.
std::string name_of(const Request& request);

/// @throw scan_cell_common::Refused if that many bytes do not fit into a datagram
void check_size(const std::string& what, std::size_t bytes);

/// @throw scan_cell_common::Refused if a value is not JSON or the packet is too long
std::string build(const Request& request, std::uint64_t session, std::uint64_t seq);

/// A datagram of the position stream.
struct StreamedState {
  std::uint64_t session = 0;
  std::uint64_t number = 0;  //!< in the session's stream, from 1
  RobotState robot;
};

struct Acknowledgement {
  std::uint64_t session = 0;
  std::uint64_t seq = 0;                 //!< number of the request
  std::optional<ControllerError> error;  //!< if there is one, nothing was done
  std::optional<RobotState> robot;
  std::string value;  //!< JSON in printable ASCII, value of a parameter; empty if there is none
};

using Reply = std::variant<StreamedState, Acknowledgement>;

/// Texts of the controller are reduced to printable ASCII, so that they can neither control a
/// terminal nor begin a line of a log.
/// @throw scan_cell_common::ProtocolError for anything but such a datagram
Reply parse(std::string_view datagram);

}  // namespace c4g_driver
