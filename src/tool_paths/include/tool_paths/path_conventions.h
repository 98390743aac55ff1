// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "tool_paths/tool_path.h"

namespace tool_paths {

/// Unit of the angles in a file.
enum class AngleUnit { kNotGiven, kDegrees, kRadians };

/// What the user specifies about a tool path's file where its names are ambiguous.
struct PathConventions {
  std::string units;             //!< m, mm or inch; empty: from the names, else metres
  std::string euler;             //!< order of the axes of Euler angles, such as zyx
  bool rotation_vector = false;  //!< the three numbers are one rotation: axis times angle
  AngleUnit angles = AngleUnit::kNotGiven;  //!< of Euler angles and rotation vectors
  std::vector<std::string> process_values;  //!< names that look like an orientation but are none
};

/// How orientations are written.
enum class OrientationKind {
  kNone,
  kQuaternion,
  kEuler,
  kRotationVector,
  kToolVector,  //!< the tool's axis alone: the rotation's z axis; the rotation about it has no
                //!< meaning
};

/// How the numbers of a pose are written.
struct PoseConvention {
  std::array<std::string, 3> position = {"x", "y", "z"};  //!< names
  std::string units = "m";                                //!< of lengths: m, mm or inch
  OrientationKind orientation = OrientationKind::kNone;   //!< how it is written
  std::vector<std::string> names;  //!< x y z w; angles in order of rotation; or x y z
  std::string euler;               //!< order of the axes
  bool degrees = false;            //!< of the angles; false: radians
};

struct YamlShape;

/// How a file writes a tool path, so that another path can be written the same way.
struct PathLayout {
  PoseConvention pose;                    //!< names, units and orientation
  std::vector<std::string> columns;       //!< of a CSV file
  std::string segment_column;             //!< of a CSV file; empty: none
  std::shared_ptr<const YamlShape> yaml;  //!< of a YAML file: its full contents
  std::vector<std::string> kept;          //!< other keys in YAML, which are kept
};

/// A tool path [m] and the layout of its file.
struct ToolPathFile {
  ToolPath path;      //!< [m]
  PathLayout layout;  //!< of the file
};

/// The contents of a tool path as understood.
struct PathContents {
  std::size_t waypoints = 0;                //!< of all segments
  std::size_t segments = 0;                 //!< of the path
  std::string orientations;                 //!< the kind, in words, or "none"
  std::string units;                        //!< of lengths: m, mm or inch
  std::vector<std::string> process_values;  //!< their names
  std::vector<std::string> kept;            //!< as in PathLayout
};

/// The contents of a path, in words for a person.
PathContents contents_of(const ToolPath& path, const PathLayout& layout = {});

/// One line for a person.
std::string to_string(const PathContents& contents);

}  // namespace tool_paths
