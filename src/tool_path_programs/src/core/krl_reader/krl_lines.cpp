// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <cctype>

#include "krl_reader/krl_reader.h"
#include "krl_values/krl_values.h"
#include "scan_cell_common/errors/text.h"
#include "text/arc_statement.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

std::string krl_literal(const Eigen::Isometry3d& pose) {
  const KrlNumbers numbers = krl_numbers(pose);
  std::string literal;
  for (std::size_t field = 0; field < numbers.size(); ++field)
    literal += std::string(field == 0 ? "{" : ",") + kKrlFields[field] + " " +
               fixed(numbers[field], krl_digits(field));
  return literal + "}";
}

/// A pose that leaves out some of its six numbers means what the motion before it leaves.
bool is_whole(const ProgramText& text, const PoseText& pose) {
  const std::string& file = text.files[pose.place.file].text;
  const std::size_t end = std::min(file.find('\n', pose.offset), file.size());
  const SourceFile line{"", file.substr(pose.offset, end - pose.offset)};
  const auto tokens = tokens_of(line, {{";"}, "\"'", "$#"});
  TokenReader reader(line, 0, tokens);
  return read_aggregate(reader).whole();
}

bool flies_by(const std::string& behind) {
  const std::string words = scan_cell_common::lower_case(behind);
  for (const char* word : {"c_dis", "c_vel", "c_ori", "c_spl", "c_ptp"})
    if (words.find(word) != std::string::npos) return true;
  return false;
}

std::vector<std::string> krl_statements(const ProgramText& text, const ArcLines& arc) {
  ArcStatement end(text, arc.step);
  const ArcText& pieces = end.pieces();
  const bool is_spline = std::tolower(end.piece(pieces.word).front()) == 's';
  end.put(pieces.word, is_spline ? "SLIN" : "LIN").put(pieces.via, "");
  const bool flies = flies_by(end.piece({pieces.target.end, pieces.statement.end}));
  std::vector<std::string> statements;
  for (const Eigen::Isometry3d& pose : arc.poses) {
    ArcStatement line = end;
    line.put(pieces.target, krl_literal(pose));
    statements.push_back(line.text() + (flies ? "" : " C_DIS"));
  }
  const PoseText& target = text.poses.at(*text.steps[arc.step].pose);
  if (!is_whole(text, target)) end.put(pieces.target, krl_literal(target.pose));
  statements.push_back(end.text());
  return statements;
}

}  // namespace

std::vector<TextEdit> krl_lines(const ProgramText& text, const std::vector<ArcLines>& arcs) {
  std::vector<TextEdit> edits;
  for (const ArcLines& arc : arcs)
    edits.push_back(in_place_of_arc(text, arc.step, krl_statements(text, arc)));
  return edits;
}

}  // namespace tool_path_programs
