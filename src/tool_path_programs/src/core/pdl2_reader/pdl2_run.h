// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "pdl2_reader/pdl2_state.h"

namespace tool_path_programs {

/// Follows a program in the order of its motion, statement by statement.
class Pdl2Run {
 public:
  Pdl2Run(const Pdl2Source& source, const ReadSettings& known, ProgramText& text);

  void run();

 private:
  struct Target {
    std::optional<Pdl2Pose> pose;
    std::vector<double> joints;  // empty: known only to the controller
  };

  void statement();
  void statement(const std::string& word);
  bool flow(const std::string& word);
  void assignment();
  void output(const std::string& variable, const Place& place);
  void call(const std::string& name);
  void enter(const Pdl2Body& body);
  void leave();
  void skip_block(const std::string& word);
  void check_line_of_block(bool first);
  void check_calls_of_line();
  void skip_statement();

  bool is_plain_arc(const ArcText& arc);
  void move(bool flies);
  MotionKind kind();
  Target target();
  Target named_target();
  void clauses();
  void with();
  void add(MotionKind kind, const std::optional<Target>& via, const Target& to, bool flies,
           const Place& place);
  std::size_t pose_text(const Pdl2Pose& pose);
  std::size_t frames_index();

  TokenReader& reader() { return readers_.back(); }
  const Pdl2Body* routine(const std::string& name) const;

  const Pdl2Source& source_;
  ProgramText& text_;
  std::set<std::string> no_motion_;
  Pdl2Variables variables_;
  Pdl2Settings settings_;
  std::vector<TokenReader> readers_;
  std::vector<const Pdl2Body*> bodies_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> poses_;  // by file and offset
  std::map<std::string, std::size_t> frames_;
  std::size_t statements_ = 0;
  std::optional<bool> arcs_are_plain_;  // judged from the whole text; none: not checked yet
};

}  // namespace tool_path_programs
