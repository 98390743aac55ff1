// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "krl_values/krl_values.h"

namespace tool_path_programs {

/// A DEF or DEFFCT.
struct KrlRoutineText {
  std::string name;                     // as written
  std::size_t file = 0;                 // index of the file
  std::size_t begin = 0;                // first statement, among the file's tokens
  std::vector<std::string> parameters;  // in lower case
  bool gives_back = false;              // a parameter is :OUT
  bool moves = false;                   // or changes frames, itself or by what it calls
  std::set<std::string> calls;          // names followed by a parenthesis, in lower case
};

/// Whether a word moves the robot or sets the frame of poses.
bool krl_word_moves(const std::string& lower_case_word);

/// The files of a program, divided into routines and data.
class KrlSource {
 public:
  /// @throw scan_cell_common::UnusableInput if a file cannot be read, or none has a routine
  explicit KrlSource(const std::vector<SourceFile>& files);

  TokenReader reader(std::size_t file, std::size_t position) const;

  const KrlRoutineText& main() const;

  /// Finds a routine by its name in lower case: in this file, else in the first that has it; null:
  /// not given.
  const KrlRoutineText* routine(const std::string& name, std::size_t from_file) const;

  /// Values in data lists: by "stem/name", global ones also by "name".
  const std::map<std::string, KrlValue>& data() const { return data_; }

  /// Prefix of a file's data: "part/".
  const std::string& scope(std::size_t file) const { return scopes_[file]; }

 private:
  void find_routines(std::size_t file);
  void read_head(TokenReader& reader, std::size_t file);
  void find_motion(KrlRoutineText& routine);
  void spread_motion();
  void read_data(std::size_t file);
  void read_declaration(TokenReader& reader, std::size_t file);

  const std::vector<SourceFile>& files_;
  std::vector<std::vector<Token>> tokens_;
  std::vector<std::string> scopes_;
  std::vector<std::unique_ptr<KrlRoutineText>> routines_;
  std::map<std::pair<std::size_t, std::string>, const KrlRoutineText*> local_;
  std::map<std::string, const KrlRoutineText*> global_;
  std::map<std::string, KrlValue> data_;
};

}  // namespace tool_path_programs
