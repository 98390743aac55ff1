// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// Transforms from the frame of a move's pose to that of the program's path.
class PathFrame {
 public:
  /// @param text must outlive it
  /// @param in_base the path is in the robot's base; false: in the user frame of the first move
  PathFrame(const ProgramText& text, bool in_base);

  /// @param step a move to a pose
  /// @throw scan_cell_common::UnusableInput if a frame's place is needed and unknown
  Eigen::Isometry3d operator()(std::size_t step) const;

 private:
  const Eigen::Isometry3d& place_of(const Frame& user, std::size_t step) const;

  const ProgramText& text_;
  const bool in_base_;
  const Frame* first_ = nullptr;  // of the program's moves
};

}  // namespace tool_path_programs
