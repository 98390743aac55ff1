// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "path/pose_convention.h"
#include "tool_paths/path_conventions.h"

namespace tool_paths {
namespace {

/// zyx as Z-Y-X
std::string in_capitals(const std::string& axes) {
  std::string text;
  for (const char axis : axes)
    text += (text.empty() ? "" : "-") + std::string(1, static_cast<char>(axis - 'a' + 'A'));
  return text;
}

std::string kind_of(const PoseConvention& convention) {
  const std::string unit = convention.degrees ? "degrees" : "radians";
  switch (convention.orientation) {
    case OrientationKind::kNone:
      return "none";
    case OrientationKind::kQuaternion:
      return "quaternions, x y z w";
    case OrientationKind::kEuler:
      return "Euler angles " + in_capitals(convention.euler) + " in " + unit;
    case OrientationKind::kRotationVector:
      return "rotation vectors in " + unit;
    case OrientationKind::kToolVector:
      return "tool vectors";
  }
  return "none";
}

std::string counted(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

}  // namespace

PathContents contents_of(const ToolPath& path, const PathLayout& layout) {
  const PoseConvention convention = convention_for(path, layout.pose);
  PathContents contents;
  contents.waypoints = waypoint_count(path);
  contents.segments = path.segments.size();
  contents.orientations = kind_of(convention);
  if (!convention.names.empty())
    contents.orientations += fmt::format(" ({})", fmt::join(convention.names, ", "));
  contents.units = convention.units;
  contents.process_values = path.process_names;
  contents.kept = layout.kept;
  return contents;
}

std::string to_string(const PathContents& contents) {
  std::string text =
      fmt::format("{} in {}, in {}; orientations: {}; process values: {}",
                  counted(contents.waypoints, "waypoint"), counted(contents.segments, "segment"),
                  contents.units, contents.orientations,
                  contents.process_values.empty()
                      ? "none"
                      : fmt::format("{}", fmt::join(contents.process_values, ", ")));
  if (!contents.kept.empty())
    text += fmt::format("; kept as they are: {}", fmt::join(contents.kept, ", "));
  return text;
}

}  // namespace tool_paths
