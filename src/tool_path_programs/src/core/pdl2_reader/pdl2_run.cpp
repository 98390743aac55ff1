// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pdl2_reader/pdl2_run.h"

#include <algorithm>

#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

constexpr std::size_t kDeepestCall = 40;
constexpr std::size_t kMostStatements =
    2000000;  // subprograms that call each other again and again

/// Whether a statement neither moves nor calls, by its first word.
bool is_passed_over(const std::string& word) {
  static const std::set<std::string> words = {
      "cycle",      "delay",      "wait",     "pause",      "attach",     "detach",  "lock",
      "unlock",     "open",       "close",    "relax",      "read",       "write",   "pulse",
      "signal",     "enable",     "disable",  "purge",      "exit",       "break",   "encode",
      "decode",     "hold",       "var",      "activate",   "deactivate", "win_del", "win_popup",
      "win_remove", "win_create", "err_post", "scrn_clear", "continue",   "endmove", "cancel",
      "resume",     "else",       "abort"};
  return words.count(word) > 0;
}

std::string end_of(const std::string& word) {
  static const std::map<std::string, std::string> ends = {
      {"if", "endif"},     {"for", "endfor"},       {"while", "endwhile"},
      {"repeat", "until"}, {"select", "endselect"}, {"condition", "endcondition"}};
  const auto found = ends.find(word);
  return found == ends.end() ? "" : found->second;
}

}  // namespace

Pdl2Run::Pdl2Run(const Pdl2Source& source, const ReadSettings& known, ProgramText& text)
    : source_(source), text_(text), variables_(source, known) {
  for (const std::string& name : known.calls_without_motion)
    no_motion_.insert(lower_case(name));
}

void Pdl2Run::run() {
  enter(source_.main());
  while (!bodies_.empty())
    statement();
}

void Pdl2Run::enter(const Pdl2Body& body) {
  bodies_.push_back(&body);
  readers_.push_back(source_.reader(body.file, body.begin));
  variables_.enter(body);
}

void Pdl2Run::leave() {
  bodies_.pop_back();
  readers_.pop_back();
  variables_.leave();
}

const Pdl2Body* Pdl2Run::routine(const std::string& name) const {
  return source_.routine(name, bodies_.back()->file);
}

void Pdl2Run::skip_statement() {
  while (!at_statement_end(reader()))
    reader().next();
  if (!reader().at_end()) reader().next();
}

void Pdl2Run::statement() {
  if (++statements_ > kMostStatements)
    reader().fail("more than 2 million statements", "give a program that ends");
  if (reader().at_end()) return leave();
  if (reader().peek().kind != TokenKind::kName) return skip_statement();
  const std::size_t depth = bodies_.size();
  statement(lower_case(reader().peek().text));
  if (bodies_.size() == depth) skip_statement();
}

void Pdl2Run::statement(const std::string& word) {
  if (word == "move" || word == "movefly") {
    reader().next();
    return move(word == "movefly");
  }
  if (flow(word) || is_passed_over(word)) return;
  const Token& after = reader().peek_after();
  const std::string symbol = after.kind == TokenKind::kSymbol ? std::string(after.text) : "";
  if (symbol == ":" || symbol == "[" || symbol == ".") return assignment();
  call(word);
}

bool Pdl2Run::flow(const std::string& word) {
  if (word == "end" || word == "return")
    leave();
  else if (!end_of(word).empty())
    skip_block(word);
  else if (word == "goto" && bodies_.back()->moves)
    reader().fail("GOTO: the order of the motions is not known", "give a program without GOTO");
  else
    return word == "goto";
  return true;
}

/// name := value; name :: is a label
void Pdl2Run::assignment() {
  const Place place = reader().place();
  const Pdl2Value unknown{{}, {}, {}, place};
  const std::string name = read_pdl2_variable(reader());
  const bool field = reader().accept('.');
  if (field && reader().at_name("aux")) return;          // other axes of an XTNDPOS
  const bool whole = !field || reader().at_name("pos");  // p.POS := of an XTNDPOS
  if (field) read_pdl2_variable(reader());
  if (!reader().accept(':') || !reader().accept('=')) return;
  if (name.rfind("$dout[", 0) == 0) return output(name, place);
  if (set(settings_, name, reader(), variables_)) return;
  Pdl2Value value = unknown;
  TokenReader line = reader();
  if (whole && line.peek().kind == TokenKind::kName && !line.at_name("pos") &&
      !line.at_name("xtndpos")) {
    const Pdl2Value* other = variables_.find(read_pdl2_variable(line));
    if (other) value = *other;
  } else if (whole) {
    value = read_pdl2_value(line);
  }
  if (!at_statement_end(line)) value = unknown;
  check_calls_of_line();
  if (!name.empty()) variables_.assign(name, value);
}

/// $DOUT[5] := ON
void Pdl2Run::output(const std::string& variable, const Place& place) {
  const bool on = reader().at_name("on") || reader().at_name("true");
  if (!on && !reader().at_name("off") && !reader().at_name("false")) return;
  text_.program.steps.emplace_back(SetOutput{variable.substr(6, variable.size() - 7), on});
  text_.steps.push_back({place, {}, {}});
}

void Pdl2Run::call(const std::string& name) {
  const Pdl2Body* body = routine(name);
  if (!body) {
    if (no_motion_.count(name) > 0) return;
    reader().fail("a call of " + name + ", which is not given",
                  "give its program, or say that it does not move");
  }
  const bool in_circle = std::find(bodies_.begin(), bodies_.end(), body) != bodies_.end();
  if (in_circle || bodies_.size() >= kDeepestCall) {
    if (!body->moves) return;
    reader().fail(in_circle ? name + " calls itself" : "calls nested 40 deep",
                  "give a program that ends");
  }
  reader().next();
  while (!at_statement_end(reader())) {  // a routine may change its arguments
    const Place place = reader().place();
    if (reader().peek().kind != TokenKind::kName) {
      reader().next();
      continue;
    }
    const std::string argument = read_pdl2_variable(reader());
    if (!argument.empty()) variables_.assign(argument, {{}, {}, {}, place});
  }
  skip_statement();
  enter(*body);
}

/// Skips a block that may run never or several times: it must not affect poses.
void Pdl2Run::skip_block(const std::string& word) {
  const std::string begin = reader().where();
  std::vector<std::string> ends;
  for (bool first = true; !reader().at_end(); skip_statement()) {
    if (reader().peek().kind == TokenKind::kName) {
      const std::string now = lower_case(reader().peek().text);
      if (now == "end") break;
      if (!end_of(now).empty()) ends.push_back(end_of(now));
      check_line_of_block(first);
      if (!ends.empty() && now == ends.back()) ends.pop_back();
    }
    first = false;
    if (ends.empty()) return;
  }
  reader().fail("the " + word + " in " + begin + " does not end", "close it");
}

void Pdl2Run::check_line_of_block(bool first) {
  if (!first && reader().peek_after().text == ":") {
    TokenReader line = reader();
    const Pdl2Value unknown{{}, {}, {}, line.place()};
    const std::string name = read_pdl2_variable(line);
    if (!name.empty()) variables_.assign(name, unknown);
  }
  for (TokenReader line = reader(); !line.at_line_end(); line.next())
    if (line.peek().kind == TokenKind::kName) {
      const std::string word = lower_case(line.peek().text);
      if (pdl2_word_moves(word) || (word == "goto" && bodies_.back()->moves))
        line.fail(word + " under a condition or in a loop: the order of the motions is not known",
                  "give a program that moves one pose after the other");
      if (word == "$lin_spd") settings_.speed.reset();
    }
  check_calls_of_line();
}

/// Checks that no routine called in the rest of the line moves.
void Pdl2Run::check_calls_of_line() {
  TokenReader line = reader();
  for (; !line.at_line_end(); line.next()) {
    if (line.peek().kind != TokenKind::kName) continue;
    const Pdl2Body* body = routine(lower_case(line.peek().text));
    if (body && body->moves)
      line.fail(body->name + " moves, and is called by a condition, a loop or a value",
                "give a program that moves one pose after the other");
  }
}

}  // namespace tool_path_programs
