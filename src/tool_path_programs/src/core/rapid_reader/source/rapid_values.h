// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "text/token_reader.h"

namespace tool_path_programs {

/// The tokens of a RAPID file without comments and line ends, which have no meaning there.
std::vector<Token> rapid_tokens(const SourceFile& file);

/// Skips one token, or a whole bracket with everything nested in it: [..], (..) or {..}.
void pass_over_brackets(TokenReader& reader);

/// The numbers of a pose as written in a text: x y z [mm], q1 (real) to q4.
struct RapidPose {
  std::array<NumberText, 7> numbers;
  std::string where;  //!< for errors

  /// @throw scan_cell_common::UnusableInput if the quaternion is invalid
  Eigen::Isometry3d pose() const;
};

/// Reads "[[x,y,z],[q1,q2,q3,q4]", the beginning of a robtarget or a pose, and no further.
/// @throw scan_cell_common::UnusableInput with file and line if a number is missing
RapidPose read_rapid_pose(TokenReader& reader);

/// The tip of a tool on the flange; none: the tool is fixed and the robot holds the part.
std::optional<Eigen::Isometry3d> read_tooldata(TokenReader& reader);

/// A work object in the world; none: the robot or another machine moves it.
std::optional<Eigen::Isometry3d> read_wobjdata(TokenReader& reader);

/// Speed of the tip in a speeddata [mm/s].
double read_speeddata(TokenReader& reader);

/// Radius of the tip's zone in a zonedata [mm]; 0: it stops.
double read_zonedata(TokenReader& reader);

/// Speed of the tip of a predefined speeddata such as v50 [mm/s].
std::optional<double> predefined_speed(const std::string& name);

/// Radius of a predefined zonedata such as z1 [mm]; 0 for fine.
std::optional<double> predefined_zone(const std::string& name);

/// Angles of the robot's axes in a jointtarget [degree].
std::vector<double> read_jointtarget(TokenReader& reader);

}  // namespace tool_path_programs
