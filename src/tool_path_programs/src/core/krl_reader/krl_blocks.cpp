// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl_reader/krl_run.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

int depth_of(const std::string& word) {
  static const std::set<std::string> begins = {"if", "for", "while", "loop", "repeat", "switch"};
  static const std::set<std::string> ends = {"endif",   "endfor", "endwhile",
                                             "endloop", "until",  "endswitch"};
  return begins.count(word) > 0 ? 1 : ends.count(word) > 0 ? -1 : 0;
}

}  // namespace

/// Skips a block that may run never or several times: it must not affect poses.
void KrlRun::skip_block() {
  const std::string begin = reader().where();
  for (int depth = 0; !reader().at_end(); reader().skip_line()) {
    if (reader().peek().kind == TokenKind::kName) {
      const std::string word = lower_case(reader().peek().text);
      if (word == "end" || word == "endfct") break;
      depth += depth_of(word);
      check_line_of_block();
    }
    if (depth == 0) return;
  }
  reader().fail("the block that begins in " + begin + " does not end", "close it");
}

void KrlRun::check_line_of_block() {
  TokenReader line = reader();
  const std::string word = lower_case(line.peek().text);
  const Token& after = line.peek_after();
  const std::string symbol = after.kind == TokenKind::kSymbol ? std::string(after.text) : "";
  if (krl_word_moves(word) || (word == "goto" && calls_.back().routine->moves))
    line.fail(word + " under a condition or in a loop: the order of the motions is not known",
              "give a program that moves one pose after the other");
  if (word == "$vel") setter_.settings.speed.reset();
  if (word == "$vel_axis") setter_.settings.joint_speed.reset();
  if (symbol == "(" && depth_of(word) == 0 && word != "wait" && no_motion_.count(word) == 0 &&
      !source_.routine(word, calls_.back().routine->file))
    line.fail("a call of " + word + ", which is not given",
              "give its file, or say that it does not move");
  if (symbol == "=" || symbol == "." || symbol == "[") {
    const KrlValue unknown{{}, {}, line.place()};
    const std::string name = read_variable(line);
    if (!name.empty()) variables_.assign(name, unknown);
  }
  check_calls_of_line();
}

/// Checks that no routine called in the rest of the line moves.
void KrlRun::check_calls_of_line() {
  TokenReader line = reader();
  while (!line.at_line_end()) {
    const Token token = line.next();
    if (token.kind != TokenKind::kName || !line.at_symbol('(')) continue;
    const std::string name = lower_case(token.text);
    const KrlRoutineText* routine = source_.routine(name, calls_.back().routine->file);
    if (routine && routine->moves)
      line.fail(name +
                    " moves, and is called by a condition, a loop, a trigger, an interrupt or a "
                    "value",
                "give a program that moves one pose after the other");
  }
}

}  // namespace tool_path_programs
