// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl_reader/krl_run.h"

#include <algorithm>

#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

constexpr std::size_t kDeepestCall = 40;
constexpr std::size_t kMostStatements =
    2000000;  // subprograms that call each other again and again

const std::set<std::string>& words_that_set() {
  static const std::set<std::string> words = {"$tool",     "$base", "$vel",
                                              "$vel_axis", "$apo",  "$ipo_mode"};
  return words;
}

/// Routines of the controller and its basic packages.
std::set<std::string> known_without_motion() {
  return {"ir_stopm", "pulse",  "cwrite", "cread",   "swrite",   "sread",   "copen",
          "cclose",   "cioctl", "sinec",  "cast_to", "strclear", "strcopy", "p00"};
}

bool is_type(const std::string& word) {
  static const std::set<std::string> words = {"int",  "real",  "bool",  "char",   "frame",
                                              "pos",  "e6pos", "axis",  "e6axis", "fdat",
                                              "ldat", "pdat",  "signal"};
  return words.count(word) > 0;
}

}  // namespace

KrlRun::KrlRun(const KrlSource& source, const ReadSettings& known, ProgramText& text)
    : source_(source),
      no_motion_(known_without_motion()),
      variables_(source),
      setter_(variables_, known),
      motions_(text, variables_, setter_) {
  for (const std::string& name : known.calls_without_motion)
    no_motion_.insert(lower_case(name));
}

void KrlRun::run() {
  enter(source_.main());
  while (!calls_.empty())
    statement();
}

void KrlRun::enter(const KrlRoutineText& routine) {
  calls_.push_back({&routine, source_.reader(routine.file, routine.begin)});
  variables_.enter(routine.file);
  for (const std::string& parameter : routine.parameters)
    variables_.declare(parameter);
}

void KrlRun::leave() {
  calls_.pop_back();
  variables_.leave();
}

void KrlRun::statement() {
  if (++statements_ > kMostStatements)
    reader().fail("more than 2 million statements", "give a program that ends");
  if (reader().at_end()) return leave();
  if (reader().peek().kind != TokenKind::kName) return reader().skip_line();
  const std::size_t depth = calls_.size();
  statement(lower_case(reader().peek().text));
  if (calls_.size() == depth) reader().skip_line();
}

void KrlRun::statement(const std::string& word) {
  if (word == "global" && reader().peek_after().kind == TokenKind::kName) {
    reader().next();
    return statement(lower_case(reader().peek().text));
  }
  if (motion(word) || setting(word) || flow(word) || declaration(word)) return;
  call_or_assignment(word);
}

bool KrlRun::motion(const std::string& word) {
  static const std::set<std::string> poses = {"ptp", "lin", "circ", "sptp", "slin", "scirc"};
  if (poses.count(word) == 0) {
    if (krl_word_moves(word) && word.front() != '$' && word != "bas" && word != "fdat_act")
      reader().fail(word + ": a motion relative to where the robot is, or along a spline",
                    "give a program of PTP, LIN, CIRC, SPTP, SLIN and SCIRC");
    return false;
  }
  const Place place = reader().place();
  reader().next();
  motions_.move(word, place, reader());
  return true;
}

bool KrlRun::setting(const std::string& word) {
  if (words_that_set().count(word) > 0) {
    reader().next();
    setter_.assign(word, reader());
  } else if (word == "bas") {
    reader().next();
    setter_.bas(reader());
  } else if (word == "fdat_act") {
    motion_data(setter_.settings.fdat, word);
  } else if (word == "ldat_act") {
    motion_data(setter_.settings.ldat, word);
  } else if (word == "$out" || word == "$out_c") {
    output();
  } else {
    return false;
  }
  return true;
}

/// FDAT_ACT=FP1
void KrlRun::motion_data(std::string& which, const std::string& name) {
  const std::string where = reader().where();
  reader().next();
  which = name + " (" + where + ")";
  if (!reader().accept('=')) return;
  if (reader().at_symbol('{')) {
    variables_.assign(name, read_value(reader()));
    which = name;
  } else if (reader().peek().kind == TokenKind::kName) {
    which = read_variable(reader());
  }
}

bool KrlRun::flow(const std::string& word) {
  static const std::set<std::string> ends = {"end", "endfct", "return", "def", "deffct"};
  static const std::set<std::string> blocks = {"if", "for", "while", "loop", "repeat", "switch"};
  if (ends.count(word) > 0)
    leave();
  else if (blocks.count(word) > 0)
    skip_block();
  else if (word == "trigger")
    trigger();
  else if (word == "interrupt")
    interrupt();
  else if (word == "goto" && calls_.back().routine->moves)
    reader().fail("GOTO: the order of the motions is not known", "give a program without GOTO");
  else
    return word == "goto" || word == "wait" || word == "continue" || word == "halt";
  return true;
}

/// DECL E6POS p1, p2
bool KrlRun::declaration(const std::string& word) {
  if (word != "decl" && !is_type(word)) return false;
  while (reader().peek_after().kind == TokenKind::kName)
    reader().next();
  while (reader().peek().kind == TokenKind::kName) {
    const std::string name = read_variable(reader());
    if (!name.empty()) variables_.declare(name);
    if (reader().accept('=')) variables_.assign(name, read_value(reader()));
    if (!reader().accept(',')) break;
  }
  return true;
}

void KrlRun::call_or_assignment(const std::string& word) {
  const Token& after = reader().peek_after();
  const bool symbol = after.kind == TokenKind::kSymbol;
  if (symbol && after.text == "(") return call(word);
  if (symbol && (after.text == "=" || after.text == "[" || after.text == ".")) assignment();
}

void KrlRun::call(const std::string& name) {
  const KrlRoutineText* routine = source_.routine(name, calls_.back().routine->file);
  if (!routine) {
    if (no_motion_.count(name) > 0) return;
    reader().fail("a call of " + name + ", which is not given",
                  "give its file, or say that it does not move");
  }
  const bool in_circle = std::any_of(calls_.begin(), calls_.end(),
                                     [&](const Call& call) { return call.routine == routine; });
  if (in_circle || calls_.size() >= kDeepestCall) {
    if (!routine->moves) return;
    reader().fail(in_circle ? name + " calls itself" : "calls nested 40 deep",
                  "give a program that ends");
  }
  if (routine->gives_back) give_back_arguments();
  reader().skip_line();
  enter(*routine);
}

/// Arguments that a routine changed are known only to the controller.
void KrlRun::give_back_arguments() {
  while (!reader().at_line_end()) {
    const Place place = reader().place();
    if (reader().peek().kind != TokenKind::kName) {
      reader().next();
      continue;
    }
    const std::string name = read_variable(reader());
    if (!name.empty()) variables_.assign(name, {{}, {}, place});
  }
}

void KrlRun::assignment() {
  const KrlValue unknown{{}, {}, reader().place()};
  const std::string name = read_variable(reader());
  KrlValue value = unknown;
  if (reader().accept('=')) {
    if (reader().peek().kind == TokenKind::kName &&
        source_.routine(lower_case(reader().peek().text), calls_.back().routine->file))
      check_calls_of_line();
    if (reader().peek().kind == TokenKind::kName) {
      const KrlValue* other = variables_.find(read_variable(reader()));
      if (other && reader().at_line_end()) value = *other;
    } else {
      value = read_value(reader());
    }
  }
  check_calls_of_line();
  if (!name.empty()) variables_.assign(name, value);
}

/// $OUT[5]=TRUE; none if the output or its value is known only to the controller.
std::optional<SetOutput> KrlRun::read_output() {
  reader().next();
  if (!reader().accept('[') || reader().peek().kind != TokenKind::kNumber) return std::nullopt;
  const std::string number(reader().next().text);
  if (!reader().accept(']') || !reader().accept('=')) return std::nullopt;
  const bool on = reader().at_name("true");
  if (!on && !reader().at_name("false")) return std::nullopt;
  return SetOutput{number, on};
}

void KrlRun::output() {
  const Place place = reader().place();
  if (const auto output = read_output()) motions_.set_output(*output, place);
}

/// TRIGGER WHEN DISTANCE=0 DELAY=0 DO $OUT[5]=TRUE: 0 is the beginning of the next motion, 1 its
/// end; WHEN PATH counts from its end.
void KrlRun::trigger() {
  const Place place = reader().place();
  motions_.trigger_at_next();
  bool at_begin = false;
  while (!reader().at_line_end() && !reader().at_name("do")) {
    const bool distance = reader().at_name("distance");
    reader().next();
    if (distance && reader().accept('='))
      at_begin = reader().peek().kind == TokenKind::kNumber && reader().peek().number == 0;
  }
  if (!reader().accept("do")) return;
  if (!reader().at_name("$out")) return check_calls_of_line();
  const auto output = read_output();
  if (output && at_begin) motions_.set_output(*output, place);
  if (output && !at_begin) motions_.set_output_behind_next(*output, place);
}

/// A routine that may be called at any time must not move.
void KrlRun::interrupt() {
  check_calls_of_line();
}

}  // namespace tool_path_programs
