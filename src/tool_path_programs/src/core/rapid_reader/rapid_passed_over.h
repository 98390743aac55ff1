// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "rapid_reader/rapid_data.h"

namespace tool_path_programs {

/// Skips blocks that may or may not be executed, which are allowed if they do not move the robot.
class RapidPassedOver {
 public:
  /// All must outlive it.
  /// @param without_motion routines known not to move, in lower case
  RapidPassedOver(const RapidSource& source, const std::set<std::string>& without_motion,
                  RapidDataState& data);

  /// Whether IF, FOR, WHILE or TEST begins here.
  static bool begins_here(const TokenReader& reader);

  /// Goes past the end of the block. What it assigns is unknown from then on.
  /// @throw scan_cell_common::UnusableInput naming file and line of a motion in it
  void pass_over(TokenReader& reader, const RapidRoutine& routine);

 private:
  int pass_over_head(TokenReader& reader);
  void pass_over_other(TokenReader& reader, const RapidRoutine& routine);
  void check_called(const RapidRoutine& routine);

  const RapidSource& source_;
  const std::set<std::string>& without_motion_;
  RapidDataState& data_;
  std::set<const RapidRoutine*> checked_;
  std::vector<const RapidRoutine*> to_check_;
};

}  // namespace tool_path_programs
