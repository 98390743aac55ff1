// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid_reader/rapid_passed_over.h"

#include "rapid_reader/rapid_instructions.h"
#include "rapid_reader/source/rapid_statement.h"
#include "rapid_reader/source/rapid_values.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

constexpr const char* kCure = "give the program that moves in one order, without conditions";

void pass_over_to(TokenReader& reader, const char* word) {
  while (!reader.at_end() && !reader.at_name(word))
    reader.next();
  reader.expect(word);
}

void pass_over_case(TokenReader& reader) {
  while (!reader.at_symbol(':'))
    pass_over_brackets(reader);
  reader.next();
}

}  // namespace

RapidPassedOver::RapidPassedOver(const RapidSource& source,
                                 const std::set<std::string>& without_motion, RapidDataState& data)
    : source_(source), without_motion_(without_motion), data_(data) {}

bool RapidPassedOver::begins_here(const TokenReader& reader) {
  return reader.at_name("IF") || reader.at_name("FOR") || reader.at_name("WHILE") ||
         reader.at_name("TEST");
}

void RapidPassedOver::pass_over(TokenReader& reader, const RapidRoutine& routine) {
  const std::size_t begin = reader.position();
  int depth = 0;
  bool one_more = false;  // the statement of an IF without THEN
  do {
    if (begins_here(reader)) {
      const int deeper = pass_over_head(reader);
      depth += deeper;
      one_more = deeper == 0;
      continue;
    }
    one_more = false;
    if (reader.accept("ENDIF") || reader.accept("ENDFOR") || reader.accept("ENDWHILE") ||
        reader.accept("ENDTEST"))
      --depth;
    else
      pass_over_other(reader, routine);
  } while (depth > 0 || one_more);
  data_.forget_assigned(begin, reader.position(), routine);
  while (!to_check_.empty()) {
    const RapidRoutine* called = to_check_.back();
    to_check_.pop_back();
    check_called(*called);
  }
}

/// By how much the block level grows.
int RapidPassedOver::pass_over_head(TokenReader& reader) {
  if (reader.accept("IF")) {
    pass_over_rapid_expression(reader);
    return reader.accept("THEN") ? 1 : 0;
  }
  if (reader.accept("TEST"))
    pass_over_rapid_expression(reader);
  else
    pass_over_to(reader, "DO");
  return 1;
}

void RapidPassedOver::pass_over_other(TokenReader& reader, const RapidRoutine& routine) {
  if (reader.accept("ELSEIF")) return pass_over_to(reader, "THEN");
  if (reader.accept("ELSE")) return;
  if (reader.at_name("CASE") || reader.at_name("DEFAULT")) return pass_over_case(reader);
  if (reader.at_name("GOTO")) reader.fail("GOTO", kCure);
  if (reader.at_name("RETURN") || reader.at_name("EXIT") || reader.at_name("CONNECT") ||
      at_rapid_assignment(reader))
    return pass_over_rapid_statement(reader);
  if (reader.peek().kind == TokenKind::kName && reader.peek_after().text == ":")
    return pass_over_case(reader);
  const TokenReader where = reader;
  const std::string name = reader.name();
  pass_over_rapid_statement(reader);
  if (rapid_motion(name) || rapid_unresolvable(name))
    where.fail(name + " under a condition or in a loop", kCure);
  if (const RapidRoutine* called = source_.routine(name, routine)) {
    if (checked_.insert(called).second) to_check_.push_back(called);
    return;
  }
  static const std::set<std::string> others = {"setdo", "set", "reset", "velset", "exitcycle"};
  const std::string key = lower_case(name);
  if (others.count(key) != 0 || rapid_moves_nothing(key) || without_motion_.count(key) != 0) return;
  where.fail("a call of " + name + ", which is not in the given files",
             "give its module, or name it as a routine without motion");
}

void RapidPassedOver::check_called(const RapidRoutine& routine) {
  TokenReader reader = source_.reader(routine.file, routine.body);
  while (reader.position() < routine.end) {
    if (begins_here(reader))
      pass_over_head(reader);
    else if (reader.at_name("ERROR") || reader.at_name("BACKWARD") || reader.at_name("UNDO"))
      break;
    else if (!(reader.accept("ENDIF") || reader.accept("ENDFOR") || reader.accept("ENDWHILE") ||
               reader.accept("ENDTEST")))
      pass_over_other(reader, routine);
  }
  data_.forget_assigned(routine.body, routine.end, routine);
}

}  // namespace tool_path_programs
