// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "text/arc_statement.h"
#include "text/number_text.h"
#include "text/rotation_vector.h"
#include "text/token_reader.h"
#include "urscript_reader/urscript_reader.h"

namespace tool_path_programs {
namespace {

constexpr double kBlend = 0.0005;      // [m] at the poses between; chosen: far below a chord
constexpr double kMostOfALine = 0.45;  // of a line; where two blends meet, a move is left out

/// The arguments of movec by name, as written.
std::map<std::string, std::string> arguments_of(const std::string& call) {
  static const std::vector<std::string> names = {"pose_via", "pose_to", "a", "v", "r", "mode"};
  const SourceFile source{"", call};
  const auto tokens = tokens_of(source, {{"#"}, "\"", ""});
  TokenReader reader(source, 0, tokens);
  reader.name();
  reader.expect('(');
  std::map<std::string, std::string> arguments;
  for (std::size_t position = 0; !reader.accept(')') && !reader.at_end(); ++position) {
    std::string name = position < names.size() ? names[position] : "";
    while (reader.at_line_end() && !reader.at_end())
      reader.next();
    if (reader.peek().kind == TokenKind::kName && reader.peek_after().text == "=") {
      name = reader.name();
      reader.next();
    }
    const std::size_t begin = reader.offset();
    for (int depth = 0; depth > 0 || !(reader.at_symbol(',') || reader.at_symbol(')'));) {
      if (reader.at_end()) break;
      if (reader.at_symbol('(') || reader.at_symbol('[')) ++depth;
      if (reader.at_symbol(')') || reader.at_symbol(']')) --depth;
      reader.next();
    }
    arguments[name] = call.substr(begin, reader.end_of_last() - begin);
    reader.accept(',');
  }
  return arguments;
}

/// A pose in the frame of the arc's end.
std::string script_literal(const ProgramText& text, std::size_t step, const Eigen::Isometry3d& pose,
                           const Eigen::Vector3d& near) {
  const Move& move = std::get<Move>(text.program.steps[step]);
  const Frame& user = text.program.frames[move.frames].user;
  const Eigen::Vector3d turn = rotation_vector_near(pose.linear(), near);
  std::string literal = "p[";
  for (Eigen::Index i = 0; i < 3; ++i)
    literal += fixed(pose.translation()[i], kScriptDigits) + ", ";
  for (Eigen::Index i = 0; i < 3; ++i)
    literal += fixed(turn[i], kScriptDigits) + (i < 2 ? ", " : "]");
  if (!user.name.empty()) return "pose_trans(" + user.name + ", " + literal + ")";
  if (user.pose && !user.pose->isApprox(Eigen::Isometry3d::Identity()))
    refuse_arc(text, step, "an arc in a frame without a name", "let the frame be a variable");
  return literal;
}

/// [m] the shortest of the lines.
double shortest_line(const ArcLines& arc, const Eigen::Isometry3d& end) {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i <= arc.poses.size(); ++i) {
    const Eigen::Isometry3d& from = i > 0 ? arc.poses[i - 1] : arc.start;
    const Eigen::Isometry3d& to = i < arc.poses.size() ? arc.poses[i] : end;
    shortest = std::min(shortest, (to.translation() - from.translation()).norm());
  }
  return shortest;
}

/// Checks that the blends of the move before and of the arc's end lie within the first and last
/// line.
void check_blends(const ProgramText& text, std::size_t step, double line) {
  const std::size_t before = move_before(text, step).value();
  for (const std::size_t each : {before, step}) {
    const double zone = std::get<Move>(text.program.steps[each]).zone;
    if (zone <= kMostOfALine * line) continue;
    refuse_arc(
        text, step,
        fmt::format("an arc that would become lines of {:.3g} mm, with a blend of {:.3g} mm at its "
                    "{}",
                    1e3 * line, 1e3 * zone, each == step ? "end" : "start"),
        "take that blend away (r=0), or write the arc as lines");
  }
}

std::vector<std::string> script_statements(const ProgramText& text, const ArcLines& arc) {
  const ArcStatement old(text, arc.step);
  const auto arguments = arguments_of(old.piece(old.pieces().statement));
  std::string speeds;
  for (const char* name : {"a", "v"})
    if (const auto found = arguments.find(name); found != arguments.end())
      speeds += std::string(", ") + name + "=" + found->second;
  const auto blend = arguments.find("r");
  const std::string zone = blend == arguments.end() ? "" : ", r=" + blend->second;
  const double line = shortest_line(arc, text.poses.at(*text.steps[arc.step].pose).pose);
  check_blends(text, arc.step, line);
  const std::string between = ", r=" + fixed(std::min(kBlend, kMostOfALine * line), kScriptDigits);
  const Eigen::Vector3d near =
      rotation_vector(text.poses.at(*text.steps[arc.step].pose).pose.linear());
  std::vector<std::string> statements;
  for (const Eigen::Isometry3d& pose : arc.poses)
    statements.push_back("movel(" + script_literal(text, arc.step, pose, near) + speeds + between +
                         ")");
  statements.push_back("movel(" + arguments.at("pose_to") + speeds + zone + ")");
  return statements;
}

}  // namespace

std::vector<TextEdit> lines_of_urscript(const ProgramText& text,
                                        const std::vector<ArcLines>& arcs) {
  return in_place_of_arcs(text, arcs, script_statements);
}

}  // namespace tool_path_programs
