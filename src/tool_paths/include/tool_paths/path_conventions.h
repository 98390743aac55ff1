// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "tool_paths/tool_path.h"

namespace tool_paths {

/// Of the angles in a file.
enum class AngleUnit { kNotGiven, kDegrees, kRadians };

/// What a person says of a tool path's file where the names in it leave it open.
struct PathConventions {
  std::string units;                        //!< m, mm or inch; empty: as the names say, else metres
  std::string euler;                        //!< order of the axes of Euler angles, such as zyx
  bool rotation_vector = false;             //!< three angles are one turn: its axis times its angle
  AngleUnit angles = AngleUnit::kNotGiven;  //!< of Euler angles and rotation vectors
  std::vector<std::string> process_values;  //!< names that are no orientation, though they look so
};

/// How orientations are written.
enum class OrientationKind {
  kNone,
  kQuaternion,
  kEuler,
  kRotationVector,
  kToolVector,  //!< the tool's axis alone: the rotation's z axis, its spin means nothing
};

/// How the numbers of a pose are written.
struct PoseConvention {
  std::array<std::string, 3> position = {"x", "y", "z"};  //!< names
  std::string units = "m";                                //!< of lengths: m, mm or inch
  OrientationKind orientation = OrientationKind::kNone;   //!< how it is written
  std::vector<std::string> names;  //!< x y z w; angles in the order of their turns; or x y z
  std::string euler;               //!< order of the axes
  bool degrees = false;            //!< of the angles; false: radians
};

struct YamlShape;

/// How a file writes a tool path, so that another path can be written alike.
struct PathLayout {
  PoseConvention pose;                    //!< names, units and orientation
  std::vector<std::string> columns;       //!< of a CSV file
  std::string segment_column;             //!< of a CSV file; empty: it has none
  std::shared_ptr<const YamlShape> yaml;  //!< of a YAML file: all that is in it
  std::vector<std::string> kept;          //!< keys in YAML that are no part of the path, kept
};

/// A tool path [m] and how its file writes it.
struct ToolPathFile {
  ToolPath path;      //!< [m]
  PathLayout layout;  //!< of the file
};

/// What a tool path was understood to hold.
struct PathContents {
  std::size_t waypoints = 0;                //!< of all segments
  std::size_t segments = 0;                 //!< of the path
  std::string orientations;                 //!< which kind, in words; "none"
  std::string units;                        //!< of lengths: m, mm or inch
  std::vector<std::string> process_values;  //!< their names
  std::vector<std::string> kept;            //!< as in PathLayout
};

/// What a path holds, in words for a person.
PathContents contents_of(const ToolPath& path, const PathLayout& layout = {});

/// In a line for a person.
std::string to_string(const PathContents& contents);

}  // namespace tool_paths
