// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool_path_programs/program.h"

namespace tool_path_programs {

/// Tools and work objects of a program, as RAPID declares and names them.
class RapidFrames {
 public:
  /// @throw scan_cell_common::UnusableInput if a tool has neither name nor pose, a name is invalid,
  /// or one name has two poses
  explicit RapidFrames(const Program& program);

  /// "tTool\WObj:=wPart"
  /// @param frames index in Program::frames
  const std::string& arguments(std::size_t frames) const { return arguments_[frames]; }
  const std::vector<std::string>& declarations() const { return declarations_; }
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::string name_of(const Frame& frame, bool tool);
  void declare(const std::string& name, const Eigen::Isometry3d& pose, bool tool);
  void note(const std::string& note);

  const Program& program_;
  std::vector<std::pair<std::string, Eigen::Isometry3d>> declared_;
  std::vector<std::string> declarations_;
  std::vector<std::string> arguments_;
  std::vector<std::string> notes_;
};

}  // namespace tool_path_programs
