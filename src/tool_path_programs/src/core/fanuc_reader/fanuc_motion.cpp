// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fanuc_reader/fanuc_motion.h"

#include <algorithm>
#include <array>

#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

constexpr const char* kAsNumbers = "write it into the program as numbers";

MotionKind read_kind(TokenReader& reader) {
  const std::string letter = lower_case(reader.name());
  if (letter == "j") return MotionKind::kJoint;
  if (letter == "l") return MotionKind::kLinear;
  if (letter == "c") return MotionKind::kCircular;
  reader.fail("a motion of kind " + letter, "the reader knows J, L and C");
}

int read_target(TokenReader& reader) {
  if (reader.at_name("PR"))
    reader.fail("a position register, which only the controller knows", "move to a position P[]");
  reader.expect("P");
  const auto index = read_fanuc_index(reader);
  if (!index) reader.fail("a position whose number only a running program knows", kAsNumbers);
  return *index;
}

/// The line may end between the two positions of an arc.
void pass_over_line_break(TokenReader& reader) {
  while (!reader.at_end() && reader.at_line_end()) {
    reader.next();
    if (reader.peek().kind == TokenKind::kNumber && reader.peek_after().text == ":") reader.next();
    reader.accept(':');
  }
}

/// Factor to metres per second of mm/sec, cm/min or inch/min.
double read_unit(TokenReader& reader) {
  const std::string length = lower_case(reader.name());
  if (!reader.accept('/')) reader.fail("a speed by time", "let the move say its speed");
  const std::string time = lower_case(reader.name());
  if (length == "mm" && time == "sec") return 1e-3;
  if (length == "cm" && time == "min") return 1e-2 / 60;
  if (length == "inch" && time == "min") return 0.0254 / 60;
  if (length == "mm" && time == "min") return 1e-3 / 60;
  reader.fail("a speed in " + length + "/" + time, "give it in mm/sec, cm/min or inch/min");
}

double read_speed(TokenReader& reader, MotionKind kind) {
  if (reader.peek().kind != TokenKind::kNumber)
    reader.fail("a speed that is not in the program", "let the move say its speed as a number");
  const double number = reader.number().value;
  if (!(number > 0)) reader.fail("a speed that is not above 0", "correct it");
  if (reader.at_symbol('%')) {
    reader.next();
    if (kind != MotionKind::kJoint) reader.fail("a share of the axes' speed", "give it in mm/sec");
    return number / 100;
  }
  const double speed = number * read_unit(reader);
  if (kind == MotionKind::kJoint)
    reader.fail("a joint move whose speed is not a share of the axes' own", "give it in %");
  return speed;
}

/// FINE, CNT50 or CR10.
double read_zone(TokenReader& reader) {
  const std::string name = lower_case(reader.name());
  if (name == "fine") return 0;
  const bool corner_region = name.compare(0, 2, "cr") == 0;
  const std::string digits = name.substr(corner_region ? 2 : std::min<std::size_t>(3, name.size()));
  const auto number = scan_cell_common::parse_number(digits);
  if (!number || (!corner_region && name.compare(0, 3, "cnt") != 0))
    reader.fail(name + " instead of FINE, CNT or CR with a number", kAsNumbers);
  if (corner_region) return 1e-3 * *number;
  return *number > 0 ? kFanucUnknownZone : 0;
}

void check_options(TokenReader& reader, std::size_t end) {
  static const std::array<const char*, 5> shifting = {"offset", "tool_offset", "voffset", "inc",
                                                      "skip"};
  while (reader.position() < end) {
    const std::string word = lower_case(reader.peek().text);
    if (std::find(shifting.begin(), shifting.end(), word) != shifting.end())
      reader.fail(word + ": only the running program knows where this ends",
                  "give a program whose poses are written in its text");
    reader.next();
  }
}

}  // namespace

FanucMotion read_fanuc_motion(TokenReader& reader, std::size_t end) {
  FanucMotion motion;
  ArcText& arc = motion.arc;
  arc.word.begin = arc.statement.begin = reader.offset();
  motion.kind = read_kind(reader);
  arc.word.end = reader.end_of_last();
  arc.target.begin = arc.via.begin = reader.offset();
  motion.target = read_target(reader);
  if (motion.kind == MotionKind::kCircular) {
    pass_over_line_break(reader);
    motion.via = motion.target;
    arc.target.begin = arc.via.end = reader.offset();
    motion.target = read_target(reader);
  }
  arc.target.end = reader.end_of_last();
  motion.speed = read_speed(reader, motion.kind);
  arc.zone.begin = reader.offset();
  motion.zone = read_zone(reader);
  arc.zone.end = reader.end_of_last();
  check_options(reader, end);
  arc.statement.end = reader.offset() + (reader.at_symbol(';') ? 1 : 0);
  return motion;
}

}  // namespace tool_path_programs
