// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tool_path_programs/language.h"
#include "tool_paths/tool_path.h"

namespace tool_path_programs {

/// How a program becomes a tool path.
struct ProgramPathSettings {
  bool in_base = false;  //!< path in the robot's base; false: in the program's user frame
  /// [m] a joint move to a pose farther than this from all lines and arcs stays as it is
  double max_joint_distance = 0.2;
  double arc_step = 0.005;        //!< [m] greatest distance between waypoints along an arc
  double arc_chord_error = 1e-4;  //!< [m] greatest distance of their lines from the arc
  bool turns_by_via = false;      //!< as Language::turns_by_via
};

/// Where a waypoint of a program's path comes from.
struct WaypointSource {
  std::size_t step = 0;             //!< of the program
  std::optional<std::size_t> pose;  //!< index in ProgramText::poses; none: a place on an arc
};

/// A program as a tool path. A pose that the program uses twice is one waypoint.
struct ProgramPath {
  tool_paths::ToolPath path;  //!< [m] a segment ends where the output or the kind of motion changes
  std::vector<WaypointSource> sources;  //!< of each waypoint, over all segments
  std::vector<std::string> kept;        //!< moves that stay as they are: where they are, and why
  ProgramPathSettings settings;         //!< that the path was made with
};

/// @throw scan_cell_common::UnusableInput if no pose is left to adapt, three poses of an arc make
/// no circle, or a frame's place is needed and unknown
ProgramPath path_of(const ProgramText& text, const ProgramPathSettings& settings = {});

/// The poses of the program after its tool path was adapted: one for each of ProgramText::poses,
/// each in its own frame.
/// @param adapted has as many waypoints as program_path.path
std::vector<Eigen::Isometry3d> poses_of(const ProgramText& text, const ProgramPath& program_path,
                                        const tool_paths::ToolPath& adapted);

/// The program with other poses.
/// @param poses one for each of text.poses
Program program_with(const ProgramText& text, const std::vector<Eigen::Isometry3d>& poses);

/// How far the arcs of a program miss the adapted path [m]: for each circular step the greatest
/// distance, 0 for other steps.
std::vector<double> arc_errors(const ProgramText& text, const ProgramPath& program_path,
                               const tool_paths::ToolPath& adapted);

/// The program's files with other poses and nothing else changed; the result is read back and
/// compared.
/// @param known the settings that the program was read with
/// @param poses one for each of text.poses
/// @throw scan_cell_common::UnusableInput if the language cannot express a pose at its place, or
/// the program read back differs
std::vector<SourceFile> with_poses(const Language& language, const ProgramText& text,
                                   const ReadSettings& known,
                                   const std::vector<Eigen::Isometry3d>& poses);

}  // namespace tool_path_programs
