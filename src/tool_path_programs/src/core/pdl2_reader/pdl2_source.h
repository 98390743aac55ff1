// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "pdl2_reader/pdl2_values.h"

namespace tool_path_programs {

/// The statements between BEGIN and END.
struct Pdl2Body {
  std::string name;              // as written
  std::size_t file = 0;          // index of the file
  std::size_t begin = 0;         // first statement, among the file's tokens
  std::set<std::string> locals;  // its parameters and variables, in lower case
  std::set<std::string> names;   // all names in it, in lower case
  bool moves = false;            // or changes frames, itself or by what it calls
};

/// The declaration of a variable.
struct Pdl2Variable {
  std::string type;      // in lower case: position, jointpos
  std::string exporter;  // program that holds it; empty: this one
};

/// Whether a word moves the robot or sets the frame of poses.
bool pdl2_word_moves(const std::string& lower_case_word);

/// The files of a program, divided into bodies and data.
class Pdl2Source {
 public:
  /// @throw scan_cell_common::UnusableInput if a file cannot be read, or the first has no BEGIN
  explicit Pdl2Source(const std::vector<SourceFile>& files);

  TokenReader reader(std::size_t file, std::size_t position) const;

  const Pdl2Body& main() const { return *main_; }

  /// Finds a routine by its name in lower case: in this file, else in the first that has it; null:
  /// not given.
  const Pdl2Body* routine(const std::string& name, std::size_t from_file) const;

  /// The declaration of a file's variable; null: not declared.
  const Pdl2Variable* variable(const std::string& name, std::size_t file) const;

  /// Values in .lsv files: by "stem/name".
  const std::map<std::string, Pdl2Value>& data() const { return data_; }

  /// Prefix of a file's data: "part/".
  const std::string& scope(std::size_t file) const { return scopes_[file]; }

 private:
  void read_program(std::size_t file);
  void read_variables(TokenReader& reader, std::size_t file, std::set<std::string>* locals);
  std::unique_ptr<Pdl2Body> read_routine_head(TokenReader& reader, std::size_t file);
  void read_body(TokenReader& reader, Pdl2Body& body);
  void read_values(std::size_t file);
  void spread_motion();

  const std::vector<SourceFile>& files_;
  std::vector<std::vector<Token>> tokens_;
  std::vector<std::string> scopes_;
  std::vector<std::unique_ptr<Pdl2Body>> bodies_;
  const Pdl2Body* main_ = nullptr;
  std::map<std::pair<std::size_t, std::string>, const Pdl2Body*> local_;
  std::map<std::string, const Pdl2Body*> global_;
  std::map<std::string, Pdl2Variable> variables_;
  std::map<std::string, Pdl2Value> data_;
};

}  // namespace tool_path_programs
