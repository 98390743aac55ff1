// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "tool_path_programs/language.h"
#include "urscript_reader/urscript_expressions.h"

namespace tool_path_programs {

/// Records what a script does, statement by statement, as a program.
class ScriptRecorder {
 public:
  /// @param settings must outlive it
  ScriptRecorder(const std::vector<SourceFile>& files, const ReadSettings& settings);

  /// Records a call that moves, switches an output or changes the tool.
  /// @param call bytes from its name to its closing bracket
  /// @return whether it is such a call
  /// @throw scan_cell_common::UnusableInput naming file and line of what cannot be resolved
  bool record(const std::string& function, const ScriptArguments& arguments, const Place& place,
              const ByteRange& call);

  ProgramText done(const std::string& name);

 private:
  struct MoveArguments;
  using LiteralId = std::pair<std::size_t, std::size_t>;  // file, offset

  void move(const std::string& function, const ScriptArguments& arguments);
  void arc(const ScriptArguments& arguments);
  void add(Move move, const ScriptValue& target, const ScriptValue* via);
  void set_speed(Move& move, const ScriptArguments& arguments, std::size_t position) const;
  void set_zone(Move& move, const ScriptArguments& arguments, std::size_t position) const;
  std::size_t pose_of(const ScriptValue& value);
  std::size_t frames_of(const ScriptValue& target);
  void set_tool(const ScriptArguments& arguments);
  bool output(const std::string& function, const ScriptArguments& arguments);
  void use_as_frame(const PoseLiteral& literal);
  double number(const ScriptValue* value, double otherwise, const std::string& what) const;
  [[noreturn]] void fail(const std::string& value, const std::string& cure) const;

  const ReadSettings& settings_;
  ProgramText text_;
  Place place_;     // of the statement
  ByteRange call_;  // likewise
  Frame tool_;
  std::string tool_key_;  // equal for equal tools
  std::map<LiteralId, std::size_t> poses_;
  std::set<LiteralId> frame_literals_;
  std::map<std::pair<std::string, std::string>, std::size_t> frames_;  // by keys of tool and user
};

}  // namespace tool_path_programs
