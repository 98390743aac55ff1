// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cctype>

#include "krl_reader/krl_reader.h"
#include "krl_values/krl_values.h"
#include "scan_cell_common/errors/text.h"
#include "text/arc_statement.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

/// X 12.3456
std::string field_text(const KrlNumbers& numbers, std::size_t field) {
  return std::string(kKrlFields[field]) + " " + fixed(numbers[field], krl_digits(field));
}

std::string krl_literal(const Eigen::Isometry3d& pose) {
  const KrlNumbers numbers = krl_numbers(pose);
  std::string literal;
  for (std::size_t field = 0; field < numbers.size(); ++field)
    literal += (field == 0 ? "{" : ",") + field_text(numbers, field);
  return literal + "}";
}

KrlAggregate aggregate_at(const ProgramText& text, const PoseText& pose) {
  const std::string& file = text.files[pose.place.file].text;
  const std::size_t end = std::min(file.find('\n', pose.offset), file.size());
  const SourceFile line{"", file.substr(pose.offset, end - pose.offset)};
  const auto tokens = tokens_of(line, {{";"}, "\"'", "$#"});
  TokenReader reader(line, 0, tokens);
  return read_aggregate(reader);
}

/// The content of braces with the missing ones of the six numbers added: they come from the end of
/// the motion before.
std::string completed(const ProgramText& text, std::size_t step, const std::string& literal,
                      const KrlAggregate& target, const Eigen::Isometry3d& pose) {
  if (literal.empty() || literal.back() != '}')
    refuse_arc(text, step, "an arc to a pose that lacks some of X, Y, Z, A, B, C", "give all six");
  const KrlNumbers numbers = krl_numbers(pose);
  std::string missing;
  for (std::size_t field = 0; field < numbers.size(); ++field)
    if (!target.number(scan_cell_common::lower_case(kKrlFields[field])))
      missing += "," + field_text(numbers, field);
  return literal.substr(0, literal.size() - 1) + missing + "}";
}

/// Refuses external axes: they would move all the way in the last line.
void check_external_axes(const ProgramText& text, std::size_t step, const KrlAggregate& target) {
  const std::size_t before = move_before(text, step).value();
  const KrlAggregate start = aggregate_at(text, text.poses[*text.steps[before].pose]);
  for (char axis = '1'; axis <= '6'; ++axis) {
    const auto there = target.number({'e', axis});
    const auto here = start.number({'e', axis});
    if (there && (!here || *here != *there))
      refuse_arc(text, step, fmt::format("an arc along which external axis E{} may move", axis));
  }
}

bool flies_by(const std::string& behind) {
  const std::string words = scan_cell_common::lower_case(behind);
  for (const char* word : {"c_dis", "c_vel", "c_ori", "c_spl", "c_ptp"})
    if (words.find(word) != std::string::npos) return true;
  return false;
}

std::vector<std::string> krl_statements(const ProgramText& text, const ArcLines& arc) {
  const PoseText& to = text.poses.at(*text.steps[arc.step].pose);
  const KrlAggregate target = aggregate_at(text, to);
  check_external_axes(text, arc.step, target);
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
  if (!target.whole())
    end.put(pieces.target, completed(text, arc.step, end.piece(pieces.target), target, to.pose));
  statements.push_back(end.text());
  return statements;
}

}  // namespace

std::vector<TextEdit> krl_lines(const ProgramText& text, const std::vector<ArcLines>& arcs) {
  return in_place_of_arcs(text, arcs, krl_statements);
}

}  // namespace tool_path_programs
