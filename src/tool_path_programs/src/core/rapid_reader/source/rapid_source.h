// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "text/token_reader.h"

namespace tool_path_programs {

/// Data that a file declares: CONST, PERS or VAR.
struct RapidData {
  std::string name;  //!< as declared
  std::string type;  //!< in lower case
  std::size_t file = 0;
  std::size_t line = 1;
  /// Among the tokens, where its value begins; of a list with numbers, that of each element. Empty:
  /// it has none in the text.
  std::vector<std::size_t> values;
  bool list = false;
};

enum class RapidRoutineKind { kProcedure, kFunction, kTrap };

/// A routine that a file declares.
struct RapidRoutine {
  RapidRoutineKind kind = RapidRoutineKind::kProcedure;
  std::string name;        //!< as declared
  std::size_t file = 0;    //!< that holds it
  std::size_t module = 0;  //!< that holds it
  std::size_t body = 0;    //!< among the tokens, its first statement
  std::size_t end = 0;     //!< among the tokens, what ends it
  /// Of its own, by names in lower case; its parameters, too, whose value the text does not say.
  std::map<std::string, RapidData> data;
};

/// What files of RAPID declare. Names are in lower case, as RAPID takes both cases for the same.
class RapidSource {
 public:
  /// @throw scan_cell_common::UnusableInput naming file and line of what is no module
  explicit RapidSource(const std::vector<SourceFile>& files);

  TokenReader reader(std::size_t file, std::size_t position) const;

  /// As seen from a routine: its own, its module's, then those that all see; null: none.
  const RapidData* data(const std::string& name, const RapidRoutine& seen_from) const;
  const RapidRoutine* routine(const std::string& name, const RapidRoutine& seen_from) const;

  const std::deque<RapidRoutine>& routines() const { return routines_; }

  /// Where the motion begins: main of the first file; the routine that is called like the file; the
  /// only one.
  /// @throw scan_cell_common::UnusableInput naming all routines if it is none of these
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
  std::map<std::string, std::size_t> global_data_;  // which module
  std::map<std::string, std::size_t> global_routines_;
};

}  // namespace tool_path_programs
