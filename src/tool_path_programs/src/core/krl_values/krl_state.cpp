// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl_values/krl_state.h"

#include <algorithm>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

bool at_value_end(const TokenReader& reader) {
  return reader.at_line_end() || reader.at_symbol(',') || reader.at_symbol(')') ||
         reader.at_name("c_spl") || reader.at_name("c_dis");
}

/// Skips a value, with parentheses, to the comma or the end after it.
void skip_value(TokenReader& reader) {
  for (std::size_t depth = 0; !reader.at_line_end(); reader.next()) {
    if (depth == 0 && at_value_end(reader)) return;
    if (reader.at_symbol('(') || reader.at_symbol('{')) ++depth;
    if ((reader.at_symbol(')') || reader.at_symbol('}')) && depth > 0) --depth;
  }
}

std::string field_behind(TokenReader& reader) {
  return reader.accept('.') ? lower_case(reader.name()) : "";
}

}  // namespace

void KrlSetter::assign(const std::string& variable, TokenReader& reader) {
  if (variable == "$vel_axis") return set_axis_speed(reader);
  const bool frame = variable == "$tool" || variable == "$base";
  const std::size_t begin = reader.position();
  const std::string field = field_behind(reader);
  if (frame && !field.empty()) {
    Frame& changed = variable == "$tool" ? settings.frames.tool : settings.frames.user;
    changed = unknown(reader, begin);
    return;
  }
  reader.expect('=');
  if (frame) return set_frame(reader, variable == "$tool");
  if (variable == "$vel") return set_speed(field, reader);
  if (variable == "$apo") return set_zone(field, reader);
  if (variable == "$ipo_mode" && reader.at_name("#TCP"))
    reader.fail("$IPO_MODE=#TCP: the tool stands still and the robot holds the part",
                "give a program whose robot holds the tool");
  skip_value(reader);
}

void KrlSetter::set_frame(TokenReader& reader, bool tool) {
  (tool ? settings.frames.tool : settings.frames.user) = frame(reader, tool);
}

/// A frame known only to the controller, different from any other.
Frame KrlSetter::unknown(TokenReader& reader, std::size_t begin) const {
  const std::string place = reader.where();
  reader.go_to(begin);
  std::string text;
  while (!reader.at_line_end()) {
    if (reader.at_symbol(',')) break;
    text += reader.next().text;
  }
  return {scan_cell_common::excerpt(text) + " (" + place + ")", {}};
}

Frame KrlSetter::numbered(const std::string& array, double number) const {
  const std::string name = array + "[" + shortest(number, 3) + "]";
  if (number == 0) return {"", Eigen::Isometry3d::Identity()};
  const auto given = known_.frames.find(name);
  if (given != known_.frames.end()) return {name, given->second};
  const KrlValue* value = variables_.find(lower_case(name));
  if (value && value->aggregate && value->aggregate->whole())
    return {name, krl_pose(value->aggregate->over({}))};
  return {name, {}};
}

Frame KrlSetter::of_fdat(const std::string& name, bool tool, const Place& place) const {
  const std::string field = tool ? "tool_no" : "base_no";
  const KrlValue* value = variables_.find(name);
  if (value && value->aggregate && value->aggregate->words.count("ipo_frame") > 0 &&
      value->aggregate->words.at("ipo_frame") == "#tcp")
    throw scan_cell_common::UnusableInput("line " + std::to_string(place.line),
                                          name + " has IPO_FRAME #TCP",
                                          "give a program whose robot holds the tool");
  const auto number = of_data(name, field);
  return number ? numbered(tool ? "TOOL_DATA" : "BASE_DATA", *number)
                : Frame{name + "." + field, {}};
}

Frame KrlSetter::frame(TokenReader& reader, bool tool) {
  const std::size_t begin = reader.position();
  const Place place = reader.place();
  if (reader.at_symbol('{')) {
    const KrlAggregate numbers = read_aggregate(reader);
    if (numbers.whole() && at_value_end(reader)) return {"", krl_pose(numbers.over({}))};
    return unknown(reader, begin);
  }
  if (reader.peek().kind != TokenKind::kName) return unknown(reader, begin);
  const std::string name = read_variable(reader);
  if (name == "$nullframe" && at_value_end(reader)) return {"", Eigen::Isometry3d::Identity()};
  if ((name == "stool2" || name == "stool" || name == "sbase") && reader.accept('(')) {
    const std::string fdat = lower_case(reader.name());
    skip_value(reader);
    reader.expect(')');
    return of_fdat(fdat, tool, place);
  }
  if (name.empty() || !at_value_end(reader)) return unknown(reader, begin);
  const std::size_t bracket = name.find('[');
  const std::string array = name.substr(0, bracket);
  if (array == "tool_data" || array == "base_data") {
    const auto number =
        scan_cell_common::parse_number(name.substr(bracket + 1, name.size() - bracket - 2));
    return numbered(array == "tool_data" ? "TOOL_DATA" : "BASE_DATA", number.value_or(-1));
  }
  const auto given = known_.frames.find(name);
  if (given != known_.frames.end()) return {name, given->second};
  const KrlValue* value = variables_.find(name);
  if (value && value->aggregate && value->aggregate->whole())
    return {name, krl_pose(value->aggregate->over({}))};
  return unknown(reader, begin);
}

std::optional<double> KrlSetter::number(TokenReader& reader) const {
  std::optional<double> value;
  if (reader.peek().kind == TokenKind::kName) {
    const KrlValue* variable = variables_.find(read_variable(reader));
    if (variable) value = variable->number;
  } else if (reader.peek().kind == TokenKind::kNumber || reader.at_symbol('-')) {
    const bool computed = reader.at_symbol('-') && reader.peek_after().kind != TokenKind::kNumber;
    if (!computed) value = reader.number().value;
  }
  if (at_value_end(reader)) return value;
  skip_value(reader);
  return std::nullopt;
}

std::optional<double> KrlSetter::of_data(const std::string& name, const std::string& field) const {
  const KrlValue* value = variables_.find(name);
  return value && value->aggregate ? value->aggregate->number(field) : std::nullopt;
}

void KrlSetter::set_speed(const std::string& field, TokenReader& reader) {
  if (field == "cp") {
    set_speed(number(reader));
  } else if (field.empty() && reader.at_symbol('{')) {
    const KrlAggregate all = read_aggregate(reader);
    if (const auto speed = all.number("cp")) set_speed(speed);
  } else if (field.empty()) {
    settings.speed.reset();
    skip_value(reader);
  } else {
    skip_value(reader);
  }
}

void KrlSetter::set_speed(const std::optional<double>& speed) {
  settings.speed = speed && *speed > 0 ? speed : std::nullopt;
}

void KrlSetter::set_joint_speed(const std::optional<double>& percent) {
  settings.joint_speed.reset();
  if (percent && *percent > 0 && *percent <= 100) settings.joint_speed = *percent / 100;
}

void KrlSetter::set_zone(const std::string& field, TokenReader& reader) {
  std::optional<double> zone;
  if (field == "cdis")
    zone = number(reader).value_or(0);
  else if (field.empty() && reader.at_symbol('{'))
    zone = read_aggregate(reader).number("cdis");
  else
    skip_value(reader);
  if (zone) settings.zone = std::max(0.0, *zone / 1000);
}

/// $VEL_AXIS[1]=50
void KrlSetter::set_axis_speed(TokenReader& reader) {
  while (!reader.at_line_end() && !reader.accept('='))
    reader.next();
  set_joint_speed(number(reader));
}

void KrlSetter::bas(TokenReader& reader) {
  const Place place = reader.place();
  const std::string where = reader.where();
  reader.expect('(');
  const std::string command = reader.at_line_end() ? "" : lower_case(reader.next().text);
  if (!reader.accept(',')) return;
  const auto value = number(reader);
  const Frame open{"BAS " + command + " (" + where + ")", {}};
  if (command == "#cp_params" || command == "#vel_cp") set_speed(value);
  if (command == "#ptp_params" || command == "#vel_ptp") set_joint_speed(value);
  if (command == "#tool") settings.frames.tool = value ? numbered("TOOL_DATA", *value) : open;
  if (command == "#base") settings.frames.user = value ? numbered("BASE_DATA", *value) : open;
  if (command == "#ex_base") settings.frames.user = open;
  if (command == "#cp_params" || command == "#ptp_params" || command == "#frames") take_fdat(place);
  if (command == "#cp_params")
    if (const auto zone = of_data(settings.ldat, "apo_dist"))
      settings.zone = std::max(0.0, *zone / 1000);
}

void KrlSetter::take_fdat(const Place& place) {
  if (settings.fdat.empty()) return;
  settings.frames.tool = of_fdat(settings.fdat, true, place);
  settings.frames.user = of_fdat(settings.fdat, false, place);
}

/// SVEL_CP(0.5, , LCPDAT1), SVEL_JOINT(80), SAPO(LCPDAT1): reads from the parenthesis.
bool KrlSetter::with_call(TokenReader& reader) {
  const bool linear = reader.at_name("svel_cp");
  const bool joint = reader.at_name("svel_joint");
  const bool zone = reader.at_name("sapo");
  if (!linear && !joint && !zone) return false;
  reader.next();
  reader.expect('(');
  if (zone) {
    const auto distance = of_data(lower_case(reader.name()), "apo_dist");
    if (distance) settings.zone = std::max(0.0, *distance / 1000);
  } else if (linear) {
    set_speed(number(reader));
  } else {
    set_joint_speed(number(reader));
  }
  while (!reader.at_line_end() && !reader.accept(')'))
    reader.next();
  return true;
}

void KrlSetter::with(TokenReader& reader) {
  do {
    const std::string variable = lower_case(reader.name());
    const std::size_t begin = reader.position();
    while (!at_value_end(reader) && !reader.accept('='))
      reader.next();
    if (!with_call(reader)) {
      reader.go_to(begin);
      assign(variable, reader);
    }
    skip_value(reader);
  } while (reader.accept(','));
}

}  // namespace tool_path_programs
