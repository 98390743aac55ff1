// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "path/number_text.h"
#include "scan_cell_common/errors/errors.h"
#include "tool_paths/tool_path_files.h"

namespace tool_paths {

std::string tool_path_to_noether_yaml(const ToolPath& path) {
  check(path);
  if (!path.has_orientation)
    throw scan_cell_common::UnusableInput("tool path '" + path.name + "'", "no orientations",
                                          "give a path with orientations: noether needs them");
  std::string text = "- # tool path\n";
  for (const Segment& segment : path.segments) {
    text += "  - # segment\n";
    const std::vector<Eigen::Quaterniond> rotations = continuous_quaternions(segment);
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
      const Eigen::Vector3d p = segment.waypoints[i].pose.translation();
      const Eigen::Quaterniond& q = rotations[i];
      text += fmt::format("    - {{x: {}, y: {}, z: {}, qw: {}, qx: {}, qy: {}, qz: {}}}\n",
                          to_text(p.x()), to_text(p.y()), to_text(p.z()), to_text(q.w()),
                          to_text(q.x()), to_text(q.y()), to_text(q.z()));
    }
  }
  return text;
}

}  // namespace tool_paths
