// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "text/token_reader.h"

namespace tool_path_programs {

/// Data declared in a file: CONST, PERS or VAR.
struct RapidData {
  std::string name;  //!< as declared
  std::string type;  //!< in lower case
  std::size_t file = 0;
  std::size_t line = 1;
  /// Token where the value begins; for a list with numbers, one per element. Empty: no value in the
  /// text.
  std::vector<std::size_t> values;
  bool list = false;
};

enum class RapidRoutineKind { kProcedure, kFunction, kTrap };

/// A routine declared in a file.
struct RapidRoutine {
  RapidRoutineKind kind = RapidRoutineKind::kProcedure;
  std::string name;        //!< as declared
  std::size_t file = 0;    //!< index of the file
  std::size_t module = 0;  //!< index of the module
  std::size_t body = 0;    //!< token of its first statement
  std::size_t end = 0;     //!< token that ends it
  /// Its own data, by name in lower case, and its parameters, whose values are not in the text.
  std::map<std::string, RapidData> data;
};

/// Declarations of RAPID files. Names are in lower case, since RAPID ignores case.
class RapidSource {
 public:
  /// @throw scan_cell_common::UnusableInput naming file and line if a file is no module
  explicit RapidSource(const std::vector<SourceFile>& files);

  TokenReader reader(std::size_t file, std::size_t position) const;

  /// Data visible in a routine: its own, its module's, then global data; null: none.
  const RapidData* data(const std::string& name, const RapidRoutine& seen_from) const;
  const RapidRoutine* routine(const std::string& name, const RapidRoutine& seen_from) const;

  const std::deque<RapidRoutine>& routines() const { return routines_; }

  /// The routine where the motion begins: main of the first file, else the routine with the file's
  /// name, else the only one.
  /// @throw scan_cell_common::UnusableInput listing all routines if there is none of these
  const RapidRoutine& first_routine() const;

 private:
  struct Module {
    std::map<std::string, RapidData> data;
    std::map<std::string, const RapidRoutine*> routines;
  };

  void read(std::size_t file);
  void read_module(TokenReader& reader, std::size_t file);
  void read_data(TokenReader& reader, std::size_t file, std::map<std::string, RapidData>& data,
                 bool local);
  void read_routine(TokenReader& reader, std::size_t file, RapidRoutineKind kind, bool local);

  const std::vector<SourceFile>& files_;
  std::vector<std::vector<Token>> tokens_;  // of each file
  std::vector<Module> modules_;
  std::deque<RapidRoutine> routines_;
  std::map<std::string, std::size_t> global_data_;  // index of the module
  std::map<std::string, std::size_t> global_routines_;
};

}  // namespace tool_path_programs
