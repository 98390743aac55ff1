// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "text/token_reader.h"
#include "text/tokens.h"

namespace tool_path_programs {

/// A range of tokens in a file.
struct TokenRange {
  std::size_t file = 0;
  std::size_t begin = 0;
  std::size_t end = 0;  //!< one past the last token
};

/// A function, thread or secondary program in a script.
struct ScriptFunction {
  std::string name;
  std::vector<std::string> parameters;
  TokenRange body;
  bool is_thread = false;     //!< runs beside the program
  bool is_outermost = false;  //!< not inside another function
  bool moves = false;         //!< itself, or what it calls
  bool acts = false;          //!< moves or switches an output
};

/// The structure of a script's files: blocks with their ends, functions, and whether they move.
class Script {
 public:
  /// @param files must outlive it
  /// @throw scan_cell_common::UnusableInput naming file and line of a block without end, or of an
  /// end without block
  explicit Script(const std::vector<SourceFile>& files);

  const std::vector<std::vector<Token>>& tokens() const { return tokens_; }
  const std::vector<ScriptFunction>& functions() const { return functions_; }
  TokenRange whole(std::size_t file) const { return {file, 0, tokens_[file].size() - 1}; }

  /// null: no function has that name.
  /// @throw scan_cell_common::UnusableInput at `place` if there are several
  const ScriptFunction* function(std::string_view name, const Place& place) const;

  /// The token `end` of the block that begins at `opening`.
  std::size_t end_of(std::size_t file, std::size_t opening) const;

  /// The first token of each call in a range; functions defined there are left out.
  std::vector<std::size_t> calls_in(const TokenRange& range) const;
  /// Names assigned in a range; functions defined there are left out.
  std::set<std::string> assigned_in(const TokenRange& range) const;

  bool moves(const TokenRange& range) const;  //!< itself, or what it calls

  Place place(std::size_t file, std::size_t token) const;
  [[noreturn]] void fail(const Place& place, const std::string& value,
                         const std::string& cure) const;

 private:
  void find_blocks(std::size_t file);
  void add_function(std::size_t file, std::size_t opening, std::size_t end, bool is_outermost);
  void find_out_what_acts();
  template <class Visit>
  void visit(const TokenRange& range, Visit visit) const;

  const std::vector<SourceFile>& files_;
  std::vector<std::vector<Token>> tokens_;                // of each file, without comments
  std::vector<std::map<std::size_t, std::size_t>> ends_;  // of each file: opening to end
  std::vector<ScriptFunction> functions_;
  std::multimap<std::string, std::size_t, std::less<>> by_name_;
};

bool is_script_symbol(const Token& token, char symbol);
bool is_script_name(const Token& token, std::string_view name);

}  // namespace tool_path_programs
