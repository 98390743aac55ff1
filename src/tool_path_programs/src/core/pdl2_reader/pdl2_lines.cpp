// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pdl2_reader/pdl2_conventions.h"
#include "pdl2_reader/pdl2_reader.h"
#include "pdl2_reader/pdl2_values.h"
#include "scan_cell_common/errors/text.h"
#include "text/arc_statement.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

/// The configuration of the pose at the arc's end; '' if it has none.
std::string configuration(const ProgramText& text, const PoseText& pose) {
  const std::string found = pdl2_pose_at(text.files[pose.place.file], pose.offset).configuration;
  return found.empty() ? "''" : found;
}

std::string pos_literal(const Eigen::Isometry3d& pose, const std::string& configuration) {
  std::string literal = "POS(";
  const Pdl2Numbers numbers = pdl2_numbers(pose);
  for (std::size_t field = 0; field < numbers.size(); ++field)
    literal += fixed(numbers[field], pdl2_digits(field)) + ", ";
  return literal + configuration + ")";
}

std::vector<std::string> pdl2_statements(const ProgramText& text, const ArcLines& arc) {
  ArcStatement end(text, arc.step);
  const ArcText& pieces = end.pieces();
  end.put(pieces.word, pieces.word.begin == pieces.word.end ? "LINEAR " : "LINEAR");
  end.put(pieces.via, "");
  const std::string move = "move";
  const std::size_t behind_move = pieces.statement.begin + move.size();
  const bool flies =
      scan_cell_common::lower_case(end.piece({behind_move, behind_move + 3})) == "fly";
  const std::string clauses =
      scan_cell_common::lower_case(end.piece({pieces.target.end, pieces.statement.end}));
  const std::string advance = clauses.find("advance") == std::string::npos ? " ADVANCE" : "";
  const PoseText& target = text.poses.at(*text.steps[arc.step].pose);
  std::vector<std::string> statements;
  for (const Eigen::Isometry3d& pose : arc.poses) {
    ArcStatement line = end;
    if (!flies) line.put({pieces.statement.begin, behind_move}, "MOVEFLY");
    line.put(pieces.target, pos_literal(pose, configuration(text, target)) + advance);
    statements.push_back(line.text());
  }
  statements.push_back(end.text());
  return statements;
}

}  // namespace

std::vector<TextEdit> pdl2_lines(const ProgramText& text, const std::vector<ArcLines>& arcs) {
  return in_place_of_arcs(text, arcs, pdl2_statements);
}

}  // namespace tool_path_programs
