// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "scan_cell_common/pose/units.h"
#include "tool_paths/path_edits.h"

namespace tool_paths {
namespace {

std::string words_of(const WaypointRange& range) {
  if (range.first == range.last) return fmt::format("waypoint {}", range.first);
  return fmt::format("waypoints {} to {}", range.first, range.last);
}

std::string words_of(EditFrame frame) {
  return frame == EditFrame::kTool ? "tool" : "path";
}

std::string words_of(const Eigen::Vector3d& numbers, double factor) {
  return fmt::format("{:.4g}, {:.4g}, {:.4g}", numbers[0] * factor, numbers[1] * factor,
                     numbers[2] * factor);
}

struct Words {
  std::string operator()(const MoveEdit& edit) const {
    return fmt::format("{} moved by {} mm ({})", words_of(edit.waypoints),
                       words_of(edit.by, scan_cell_common::kMillimetres), words_of(edit.frame));
  }
  std::string operator()(const TurnEdit& edit) const {
    return fmt::format("{} turned by {:.4g} degrees about {} ({})", words_of(edit.waypoints),
                       edit.angle * scan_cell_common::kDegrees, words_of(edit.about, 1),
                       words_of(edit.frame));
  }
  std::string operator()(const DeleteEdit& edit) const {
    return words_of(edit.waypoints) + " deleted";
  }
  std::string operator()(const AddEdit& edit) const {
    return fmt::format("a waypoint added after {}, at {:.4g} of the way", edit.after, edit.share);
  }
  std::string operator()(const SetEdit& edit) const {
    std::string text = words_of(edit.waypoints) + " given";
    for (const auto& [name, value] : edit.values)
      text += fmt::format(" {} {:.6g}", name, value);
    return text;
  }
};

}  // namespace

std::string to_string(const PathEdit& edit) {
  return std::visit(Words(), edit);
}

}  // namespace tool_paths
