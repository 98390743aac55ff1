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

/// What data of a program are worth while it is gone through in the order of the motion.
class RapidDataState {
 public:
  /// Both must outlive it.
  RapidDataState(const RapidSource& source, const ReadSettings& settings);

  /// At the value of an argument: itself if it stands there, else where the data that it names got
  /// theirs.
  /// @throw scan_cell_common::UnusableInput naming file and line where the text does not say it
  TokenReader value_of(const RapidArgument& argument, const RapidRoutine& routine) const;

  /// None where the text does not say it.
  std::optional<TokenReader> known_value_of(const RapidArgument& argument,
                                            const RapidRoutine& routine) const;

  double speed_of(const RapidArgument& argument, const RapidRoutine& routine) const;  //!< [mm/s]
  double zone_of(const RapidArgument& argument, const RapidRoutine& routine) const;   //!< [mm]
  bool output_of(const RapidArgument& argument, const RapidRoutine& routine) const;

  Frame tool_of(const RapidArgument& argument, const RapidRoutine& routine);
  Frame user_of(const RapidArgument& argument, const RapidRoutine& routine);

  /// An assignment that is certain to be executed; goes behind it.
  void assign(TokenReader& reader, const RapidRoutine& routine);

  /// All assignments between two places may be executed or not.
  void forget_assigned(std::size_t begin, std::size_t end, const RapidRoutine& routine);

 private:
  struct Changed {
    std::optional<std::size_t> value;  // where it stands; none: computed
    std::size_t file = 0;
    std::size_t line = 0;
  };

  using ReadFrame = std::optional<Eigen::Isometry3d> (*)(TokenReader&);

  Frame frame_of(const RapidArgument& argument, const RapidRoutine& routine, const char* predefined,
                 ReadFrame read);
  TokenReader at(const RapidArgument& argument, const RapidRoutine& routine) const;
  void forget(const RapidData& data, const TokenReader& where);
  /// A name that stands alone and is not declared in the files, such as v50; else empty.
  std::string undeclared_name(const RapidArgument& argument, const RapidRoutine& routine) const;
  [[noreturn]] void fail_at(const RapidArgument& argument, const RapidRoutine& routine) const;

  const RapidSource& source_;
  std::map<std::string, Eigen::Isometry3d> known_frames_;  // by names in lower case
  std::map<const RapidData*, Changed> changed_;
  std::set<const RapidData*> frames_in_use_;     // that moves were in
  std::set<const RapidData*> moved_frames_;      // changed after a move in them
  std::map<std::string, std::string> spelling_;  // of frames, as it came first
};

}  // namespace tool_path_programs
