// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>

#include "krl_values/krl_conventions.h"
#include "text/token_reader.h"

namespace tool_path_programs {

/// What stands in braces: {X 1,Y 2,A 0} or {TOOL_NO 1,BASE_NO 0}. Names in lower case.
struct KrlAggregate {
  std::map<std::string, NumberText> numbers;  //!< of its own fields
  std::map<std::string, std::string> words;   //!< #BASE, TRUE
  std::size_t offset = 0;                     //!< of its brace
  Place place;

  std::optional<double> number(const std::string& field) const;
  bool has_axes() const;  //!< A1 ... E6: it is no pose
  bool has_pose() const;  //!< at least one of X Y Z A B C

  /// All six given.
  bool whole() const;

  /// Those that it has, over the others.
  KrlNumbers over(const KrlNumbers& others) const;
};

/// Reads what the next brace opens.
/// @throw scan_cell_common::UnusableInput if a value is neither a number nor a word or text
KrlAggregate read_aggregate(TokenReader& reader);

/// What a name stands for. Neither: it was given a value that only the controller knows.
struct KrlValue {
  std::optional<KrlAggregate> aggregate;
  std::optional<double> number;
  Place place;  //!< where it got it
};

/// What stands behind an "=", if it is an aggregate or a number and nothing follows on its line or
/// before a comma; the reader ends there.
KrlValue read_value(TokenReader& reader);

/// A name as it is used: "p1", "points[3]", in lower case; a field is not part of it. Empty if an
/// index is not a number: then only the controller knows which.
std::string read_variable(TokenReader& reader);

}  // namespace tool_path_programs
