// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "text/token_reader.h"

namespace tool_path_programs {

/// A position of a program's /POS section, for the first motion group.
struct FanucPosition {
  std::size_t offset = 0;  //!< of its first byte
  std::size_t line = 1;
  std::optional<int> user_frame;                  //!< none: F, the selected one
  std::optional<int> tool;                        //!< as user_frame
  std::array<std::optional<NumberText>, 6> pose;  //!< X Y Z [mm] W P R [degree]
  std::vector<double> joints;                     //!< [degree] if it is given by joint angles
};

/// Reads from "P[" up to and including its "};".
FanucPosition read_fanuc_position(TokenReader& reader);

/// What a statement does, as far as it matters to the order of the motion.
enum class FanucStatementKind {
  kMotion,
  kFrame,   //!< selects or changes a frame or tool
  kOutput,  //!< DO[..]= or RO[..]= without a condition
  kCall,    //!< without a condition
  kBegin,   //!< IF .. THEN, FOR: the block up to its end may run never, once or several times
  kEnd,     //!< of such a block
  kLabel,
  kStop,     //!< END, ABORT: the program ends
  kBranch,   //!< IF, SELECT, JMP, or what else names a label or calls under a condition
  kChanged,  //!< P[..]=
  kOther,
};

struct FanucStatement {
  FanucStatementKind kind = FanucStatementKind::kOther;
  std::size_t begin = 0;  //!< token after the line number
  std::size_t end = 0;    //!< token of the semicolon or the end of the line
  int label = 0;          //!< of kLabel
};

/// A program of one file.
struct FanucProgram {
  std::string name;  //!< in upper case
  std::size_t file = 0;
  std::vector<FanucStatement> statements;
  std::map<int, FanucPosition> positions;
};

/// Programs as FANUC's controllers save them as text.
class FanucSource {
 public:
  /// @throw scan_cell_common::UnusableInput naming file and line if a file is no program
  explicit FanucSource(const std::vector<SourceFile>& files);

  TokenReader reader(std::size_t file, std::size_t position) const;
  const std::deque<FanucProgram>& programs() const { return programs_; }  //!< one per file
  const FanucProgram* program(const std::string& name) const;             //!< null: not given

 private:
  void read(std::size_t file);
  void read_statements(TokenReader& reader, FanucProgram& program);
  void read_positions(TokenReader& reader, FanucProgram& program);

  const std::vector<SourceFile>& files_;
  std::vector<std::vector<Token>> tokens_;
  std::deque<FanucProgram> programs_;
};

/// Tokens of a program. Comments and quotes are not recognized, as both may hold any text.
std::vector<Token> fanuc_tokens(const SourceFile& file);

/// [5] or [5:name]; none if the index is a register.
std::optional<int> read_fanuc_index(TokenReader& reader);

}  // namespace tool_path_programs
