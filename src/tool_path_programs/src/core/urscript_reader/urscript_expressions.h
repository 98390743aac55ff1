// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "text/token_reader.h"
#include "urscript_reader/urscript_values.h"

namespace tool_path_programs {

/// The arguments of a call.
struct ScriptArguments {
  std::vector<ScriptValue> positional;
  std::map<std::string, ScriptValue> named;

  /// By name, or else by position; null: left out.
  const ScriptValue* find(const std::string& name, std::size_t position) const;
};

/// Evaluates expressions of a script, where the text gives their values.
class ScriptExpressions {
 public:
  /// Both must outlive it.
  ScriptExpressions(TokenReader& reader, const ScriptVariables& variables)
      : reader_(reader), variables_(variables) {}

  /// Reads from the next token to the end of the expression.
  ScriptValue value();

  /// Reads from the opening bracket past the closing one.
  ScriptArguments arguments();

 private:
  ScriptValue sum();
  ScriptValue product();
  ScriptValue factor();
  ScriptValue named();
  ScriptValue call(const std::string& function);
  ScriptValue pose(const Place& place, std::size_t offset);
  ScriptValue list();
  std::optional<std::vector<double>> numbers(std::vector<bool>& plain);
  bool at_delimiter() const;
  void pass_rest();
  void pass_lines();

  TokenReader& reader_;
  const ScriptVariables& variables_;
  std::size_t depth_ = 0;  // of brackets
};

}  // namespace tool_path_programs
