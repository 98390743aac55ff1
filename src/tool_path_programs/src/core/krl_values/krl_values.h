// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>

#include "krl_values/krl_conventions.h"
#include "text/token_reader.h"

namespace tool_path_programs {

/// The content of braces: {X 1,Y 2,A 0} or {TOOL_NO 1,BASE_NO 0}. Names in lower case.
struct KrlAggregate {
  std::map<std::string, NumberText> numbers;  //!< of its own fields
  std::map<std::string, std::string> words;   //!< #BASE, TRUE
  std::size_t offset = 0;                     //!< of its brace
  Place place;

  std::optional<double> number(const std::string& field) const;
  bool has_axes() const;  //!< A1 ... E6: it is no pose
  bool has_pose() const;  //!< at least one of X Y Z A B C

  /// Whether all six are given.
  bool whole() const;

  /// The numbers given here, the missing ones taken from `others`.
  KrlNumbers over(const KrlNumbers& others) const;
};

/// Reads the aggregate that the next brace opens.
/// @throw scan_cell_common::UnusableInput if a value is neither a number nor a word or text
KrlAggregate read_aggregate(TokenReader& reader);

/// The value of a name. Neither set: known only to the controller.
struct KrlValue {
  std::optional<KrlAggregate> aggregate;
  std::optional<double> number;
  Place place;  //!< where it was assigned
};

/// Reads the value after "=" if it is an aggregate or a number, and nothing else follows before the
/// end of the line or a comma; the reader ends there.
KrlValue read_value(TokenReader& reader);

/// Reads a name as it is used: "p1", "points[3]", in lower case, without a field. Empty if an index
/// is not a number: the element is known only to the controller.
std::string read_variable(TokenReader& reader);

}  // namespace tool_path_programs
