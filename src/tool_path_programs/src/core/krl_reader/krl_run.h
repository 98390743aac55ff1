// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "krl_reader/krl_motions.h"
#include "krl_values/krl_source.h"
#include "krl_values/krl_state.h"

namespace tool_path_programs {

/// Follows a program in the order of its motion, statement by statement.
class KrlRun {
 public:
  KrlRun(const KrlSource& source, const ReadSettings& known, ProgramText& text);

  void run();

 private:
  struct Call {
    const KrlRoutineText* routine;
    TokenReader reader;
  };

  void statement();
  void statement(const std::string& word);
  bool motion(const std::string& word);
  bool setting(const std::string& word);
  bool flow(const std::string& word);
  bool declaration(const std::string& word);
  void call_or_assignment(const std::string& word);

  void enter(const KrlRoutineText& routine);
  void leave();
  void call(const std::string& name);
  void give_back_arguments();
  void assignment();
  void output();
  void trigger();
  void interrupt();
  void motion_data(std::string& which, const std::string& name);
  void skip_block();
  void check_line_of_block();
  void check_calls_of_line();

  TokenReader& reader() { return calls_.back().reader; }
  std::optional<SetOutput> read_output();

  const KrlSource& source_;
  std::set<std::string> no_motion_;
  KrlVariables variables_;
  KrlSetter setter_;
  KrlMotions motions_;
  std::vector<Call> calls_;
  std::size_t statements_ = 0;
};

}  // namespace tool_path_programs
