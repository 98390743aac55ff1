// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pdl2_reader/pdl2_conventions.h"
#include "text/token_reader.h"

namespace tool_path_programs {

const LexicalRules& pdl2_rules();

/// A pose written as six numbers: POS(1, 2, 3, 0, 90, 0, ''), or X:1 Y:2 Z:3 A:0 E:90 R:0.
struct Pdl2Pose {
  std::array<NumberText, 6> numbers{};
  std::size_t offset = 0;  // of POS or X
  Place place;
  std::string configuration;  // with its quotes; empty: none is written

  Pdl2Numbers values() const;
};

/// The value of a name. All empty: known only to the controller.
struct Pdl2Value {
  std::optional<Pdl2Pose> pose;
  std::optional<std::vector<double>> joints;  // {1, 2, 3}
  std::optional<double> number;
  Place place;  // where it was assigned
};

/// Reads from POS or X; none if one of the six is not a number, and the reader is then somewhere
/// after POS or X.
std::optional<Pdl2Pose> read_pos(TokenReader& reader);

/// Reads a pose again from whole lines, so that no quote is cut; numbers are counted from `offset`.
/// @param offset of a pose returned by read_pos()
Pdl2Pose pdl2_pose_at(const SourceFile& file, std::size_t offset);

/// Reads a literal: POS(..), XTNDPOS(POS(..), ..), {..}, a number.
Pdl2Value read_pdl2_value(TokenReader& reader);

/// Reads a name as it is used: "p1", "points[3]", in lower case. Empty if an index is not a number.
std::string read_pdl2_variable(TokenReader& reader);

/// Goes past the parenthesis that closes the last one opened.
void skip_parentheses(TokenReader& reader);

/// Whether a statement ends here.
bool at_statement_end(const TokenReader& reader);

}  // namespace tool_path_programs
