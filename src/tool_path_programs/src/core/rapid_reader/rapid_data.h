// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "rapid_reader/source/rapid_source.h"
#include "rapid_reader/source/rapid_statement.h"
#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// Values of a program's data while the program is followed in the order of the motion.
class RapidDataState {
 public:
  /// Both must outlive it.
  RapidDataState(const RapidSource& source, const ReadSettings& settings);

  /// A reader at an argument's value: at the argument if it is a literal, else where the named data
  /// got its value.
  /// @throw scan_cell_common::UnusableInput naming file and line if the text does not give the
  /// value
  TokenReader value_of(const RapidArgument& argument, const RapidRoutine& routine) const;

  /// none: the text does not give the value.
  std::optional<TokenReader> known_value_of(const RapidArgument& argument,
                                            const RapidRoutine& routine) const;

  double speed_of(const RapidArgument& argument, const RapidRoutine& routine) const;  //!< [mm/s]
  double zone_of(const RapidArgument& argument, const RapidRoutine& routine) const;   //!< [mm]
  bool output_of(const RapidArgument& argument, const RapidRoutine& routine) const;

  Frame tool_of(const RapidArgument& argument, const RapidRoutine& routine);
  Frame user_of(const RapidArgument& argument, const RapidRoutine& routine);

  /// Reads an assignment that is certain to be executed.
  void assign(TokenReader& reader, const RapidRoutine& routine);

  /// Notes that assignments between two places may or may not be executed.
  void forget_assigned(std::size_t begin, std::size_t end, const RapidRoutine& routine);

 private:
  struct Changed {
    std::optional<std::size_t> value;  // where it is in the text; none: computed
    std::size_t file = 0;
    std::size_t line = 0;
  };

  using ReadFrame = std::optional<Eigen::Isometry3d> (*)(TokenReader&);

  Frame frame_of(const RapidArgument& argument, const RapidRoutine& routine, const char* predefined,
                 ReadFrame read);
  TokenReader at(const RapidArgument& argument, const RapidRoutine& routine) const;
  void forget(const RapidData& data, const TokenReader& where);
  /// A name that is the whole argument and not declared in the files, such as v50; else empty.
  std::string undeclared_name(const RapidArgument& argument, const RapidRoutine& routine) const;
  [[noreturn]] void fail_at(const RapidArgument& argument, const RapidRoutine& routine) const;

  const RapidSource& source_;
  std::map<std::string, Eigen::Isometry3d> known_frames_;  // by name in lower case
  std::map<const RapidData*, Changed> changed_;
  std::set<const RapidData*> frames_in_use_;     // used by moves so far
  std::set<const RapidData*> moved_frames_;      // changed after a move in them
  std::map<std::string, std::string> spelling_;  // of frames, as first written
};

}  // namespace tool_path_programs
