// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

#include "fanuc_reader/fanuc_source.h"

namespace tool_path_programs {

constexpr std::size_t kDeepestFanucCall = 50;  // chosen

/// Checks that a program's statements run in the order in which they are written, where that
/// matters to its motion.
class FanucFlow {
 public:
  /// Both must outlive it.
  /// @param without_motion programs known not to move, in lower case
  FanucFlow(const FanucSource& source, const std::set<std::string>& without_motion);

  /// @throw scan_cell_common::UnusableInput naming file and line of a motion or a change of frames
  /// under a condition, in a loop or between a jump and its label, or of a call of an unknown
  /// program
  void check(const FanucProgram& program);

  /// Whether a program moves or changes frames, itself or by what it calls.
  bool moves(const std::string& program, const TokenReader& where);

 private:
  bool moves(const FanucStatement& statement, const FanucProgram& program);
  void check_branch(const FanucProgram& program, std::size_t i,
                    const std::map<int, std::size_t>& labels,
                    const std::vector<std::size_t>& moving);

  const FanucSource& source_;
  const std::set<std::string>& without_motion_;
  std::map<const FanucProgram*, bool> moves_;
  std::size_t depth_ = 0;
};

}  // namespace tool_path_programs
