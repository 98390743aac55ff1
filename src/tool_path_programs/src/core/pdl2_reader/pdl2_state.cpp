// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pdl2_reader/pdl2_state.h"

#include <algorithm>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

std::string array_of(const std::string& name) {
  return name.substr(0, name.find('['));
}

bool at_value_end(const TokenReader& reader) {
  return at_statement_end(reader) || reader.at_symbol(',') || reader.at_name("endmove") ||
         reader.at_name("with") || reader.at_name("advance");
}

void skip_value(TokenReader& reader) {
  while (!at_value_end(reader)) {
    if (reader.next().text == "(") skip_parentheses(reader);
  }
}

/// A frame known only to the controller, different from any other.
Frame unknown(const std::string& text, const std::string& where) {
  return {scan_cell_common::excerpt(text) + " (" + where + ")", {}};
}

Frame read_frame(TokenReader& reader, const Pdl2Variables& variables) {
  const std::string where = reader.where();
  const std::string text(reader.peek().text);
  Frame frame = unknown(text, where);
  if (reader.at_name("pos")) {
    const Pdl2Value value = read_pdl2_value(reader);
    if (value.pose) frame = {"", pdl2_pose(value.pose->values())};
  } else if (reader.peek().kind == TokenKind::kName) {
    const std::string name = read_pdl2_variable(reader);
    if (!name.empty() && at_value_end(reader)) return variables.frame(name);
  }
  if (at_value_end(reader)) return frame;
  skip_value(reader);
  return unknown(text, where);
}

std::optional<double> read_number(TokenReader& reader, const Pdl2Variables& variables) {
  std::optional<double> number;
  if (reader.peek().kind == TokenKind::kName) {
    const Pdl2Value* value = variables.find(read_pdl2_variable(reader));
    if (value) number = value->number;
  } else {
    number = read_pdl2_value(reader).number;
  }
  if (at_value_end(reader)) return number;
  skip_value(reader);
  return std::nullopt;
}

double share(const std::optional<double>& percent) {
  return percent && *percent > 0 && *percent <= 100 ? *percent / 100 : 1;
}

}  // namespace

Pdl2Variables::Pdl2Variables(const Pdl2Source& source, const ReadSettings& known)
    : source_(source), known_(known), data_(source.data()) {}

std::string Pdl2Variables::key(const std::string& name) const {
  const Pdl2Variable* declared = source_.variable(array_of(name), body().file);
  if (declared && !declared->exporter.empty()) return lower_case(declared->exporter) + "/" + name;
  return source_.scope(body().file) + name;
}

void Pdl2Variables::assign(const std::string& name, const Pdl2Value& value) {
  if (body().locals.count(array_of(name)) > 0)
    bodies_.back().values[name] = value;
  else
    data_[key(name)] = value;
}

const Pdl2Value* Pdl2Variables::find(const std::string& name) const {
  const bool local = body().locals.count(array_of(name)) > 0;
  const auto& values = local ? bodies_.back().values : data_;
  const auto found = values.find(local ? name : key(name));
  return found == values.end() ? nullptr : &found->second;
}

std::string Pdl2Variables::type(const std::string& name) const {
  const Pdl2Variable* declared = source_.variable(array_of(name), body().file);
  return declared ? declared->type : "";
}

Frame Pdl2Variables::frame(const std::string& name) const {
  const Pdl2Variable* declared = source_.variable(array_of(name), body().file);
  const bool elsewhere = declared && !declared->exporter.empty();
  Frame frame{(elsewhere ? declared->exporter + "." : "") + name, {}};
  const auto given = known_.frames.find(frame.name);
  if (given != known_.frames.end()) {
    frame.pose = given->second;
  } else if (const Pdl2Value* value = find(name)) {
    if (value->pose) return {"", pdl2_pose(value->pose->values())};
    frame.name += " (line " + std::to_string(value->place.line) + ")";
  }
  return frame;
}

/// $UFRAME is in the world, and so is the robot's $BASE.
Frames Pdl2Settings::frames() const {
  Frames frames{tool, uframe};
  if (!base) return frames;
  frames.user.name += base->name.empty() ? "" : " from " + base->name;
  if (base->pose && uframe.pose)
    frames.user.pose = base->pose->inverse() * *uframe.pose;
  else
    frames.user.pose.reset();
  return frames;
}

bool set(Pdl2Settings& settings, const std::string& variable, TokenReader& reader,
         const Pdl2Variables& variables) {
  if (variable == "$tool") {
    settings.tool = read_frame(reader, variables);
  } else if (variable == "$uframe") {
    settings.uframe = read_frame(reader, variables);
  } else if (variable == "$base") {
    settings.base = read_frame(reader, variables);
  } else if (variable == "$move_type") {
    if (reader.peek().kind == TokenKind::kName) settings.move_type = lower_case(reader.next().text);
  } else if (variable == "$lin_spd") {
    settings.speed = read_number(reader, variables);
    if (settings.speed && !(*settings.speed > 0)) settings.speed.reset();
  } else if (variable == "$prog_spd_ovr") {
    settings.program_override = share(read_number(reader, variables));
  } else if (variable == "$arm_spd_ovr") {
    settings.arm_override = share(read_number(reader, variables));
  } else if (variable == "$fly_dist") {
    settings.fly_distance = std::max(0.0, read_number(reader, variables).value_or(0) / 1000);
  } else {
    return false;
  }
  return true;
}

}  // namespace tool_path_programs
