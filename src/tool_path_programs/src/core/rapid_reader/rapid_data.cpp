// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid_reader/rapid_data.h"

#include "rapid_reader/source/rapid_values.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

constexpr int kMostNames = 20;  // a := b, b := c and so on

/// The element of data that a name means, with the {3} after it if they are a list.
std::optional<std::size_t> element_at(TokenReader& reader, const RapidData& data) {
  std::size_t element = 0;
  if (data.list) {
    if (!reader.accept('{') || reader.peek().kind != TokenKind::kNumber) return std::nullopt;
    const double number = reader.number().value;
    if (!(number >= 1 && number <= 1e9) || !reader.accept('}')) return std::nullopt;
    element = static_cast<std::size_t>(number) - 1;
  }
  return element;
}

}  // namespace

RapidDataState::RapidDataState(const RapidSource& source, const ReadSettings& settings)
    : source_(source) {
  for (const auto& [name, pose] : settings.frames)
    known_frames_[lower_case(name)] = pose;
}

TokenReader RapidDataState::at(const RapidArgument& argument, const RapidRoutine& routine) const {
  return source_.reader(routine.file, argument.begin);
}

std::string RapidDataState::undeclared_name(const RapidArgument& argument,
                                            const RapidRoutine& routine) const {
  const TokenReader reader = at(argument, routine);
  const std::string name(reader.peek().text);
  const bool alone = reader.position() + 1 == argument.end;
  return alone && !source_.data(name, routine) ? name : "";
}

std::optional<TokenReader> RapidDataState::known_value_of(const RapidArgument& argument,
                                                          const RapidRoutine& routine) const {
  std::optional<TokenReader> reader = at(argument, routine);
  std::size_t end = argument.end;
  for (int names = 0; names < kMostNames; ++names) {
    if (reader->at_symbol('[') || reader->peek().kind == TokenKind::kNumber) return reader;
    if (reader->peek().kind != TokenKind::kName) return std::nullopt;
    const RapidData* data = source_.data(std::string(reader->next().text), routine);
    if (!data) return std::nullopt;
    const auto element = element_at(*reader, *data);
    const bool alone = end == 0 ? reader->at_symbol(';') : reader->position() == end;
    if (!element || !alone) return std::nullopt;
    const auto changed = changed_.find(data);
    if (changed == changed_.end() && *element < data->values.size())
      reader.emplace(source_.reader(data->file, data->values[*element]));
    else if (changed != changed_.end() && !data->list && changed->second.value)
      reader.emplace(source_.reader(changed->second.file, *changed->second.value));
    else
      return std::nullopt;
    end = 0;
  }
  return std::nullopt;
}

TokenReader RapidDataState::value_of(const RapidArgument& argument,
                                     const RapidRoutine& routine) const {
  if (const auto reader = known_value_of(argument, routine)) return *reader;
  fail_at(argument, routine);
}

void RapidDataState::fail_at(const RapidArgument& argument, const RapidRoutine& routine) const {
  TokenReader reader = at(argument, routine);
  const std::string name(reader.peek().text);
  if (reader.at_symbol('*')) reader.fail("*, a position that is not in the text", "give it a name");
  const bool named = reader.peek().kind == TokenKind::kName;
  const RapidData* data = named ? source_.data(name, routine) : nullptr;
  if (!data && named && reader.position() + 1 == argument.end)
    reader.fail(name + " is not in the given files", "give the module that declares it");
  if (data && changed_.count(data) != 0)
    reader.fail(
        name + " is computed at run time, in line " + std::to_string(changed_.at(data).line),
        "write it into the program as numbers");
  if (data && data->values.empty())
    reader.fail(name + " has no value in the text", "write it into the program as numbers");
  reader.fail(scan_cell_common::excerpt(name) + ".., a value that is computed at run time",
              "write it into the program as numbers");
}

double RapidDataState::speed_of(const RapidArgument& argument, const RapidRoutine& routine) const {
  if (auto reader = known_value_of(argument, routine)) return read_speeddata(*reader);
  if (const auto speed = predefined_speed(undeclared_name(argument, routine))) return *speed;
  fail_at(argument, routine);
}

double RapidDataState::zone_of(const RapidArgument& argument, const RapidRoutine& routine) const {
  if (auto reader = known_value_of(argument, routine)) return read_zonedata(*reader);
  if (const auto zone = predefined_zone(undeclared_name(argument, routine))) return *zone;
  fail_at(argument, routine);
}

bool RapidDataState::output_of(const RapidArgument& argument, const RapidRoutine& routine) const {
  const std::string name = lower_case(undeclared_name(argument, routine));
  if (name == "high" || name == "low") return name == "high";
  TokenReader reader = value_of(argument, routine);
  const double value = reader.number().value;
  const bool alone = reader.at_symbol(',') || reader.at_symbol(';');
  if (!alone || (value != 0 && value != 1))
    at(argument, routine).fail("an output that is set to neither 0 nor 1", "set it to 0 or 1");
  return value == 1;
}

Frame RapidDataState::tool_of(const RapidArgument& argument, const RapidRoutine& routine) {
  return frame_of(argument, routine, "tool0", read_tooldata);
}

Frame RapidDataState::user_of(const RapidArgument& argument, const RapidRoutine& routine) {
  return frame_of(argument, routine, "wobj0", read_wobjdata);
}

Frame RapidDataState::frame_of(const RapidArgument& argument, const RapidRoutine& routine,
                               const char* predefined, ReadFrame read) {
  TokenReader reader = at(argument, routine);
  if (reader.peek().kind != TokenKind::kName || reader.position() + 1 != argument.end)
    fail_at(argument, routine);
  const std::string name(reader.peek().text);
  const std::string key = lower_case(name);
  Frame frame{spelling_.emplace(key, name).first->second, std::nullopt};
  const RapidData* data = source_.data(name, routine);
  if (const auto known = known_frames_.find(key); known != known_frames_.end())
    frame.pose = known->second;
  else if (auto value = known_value_of(argument, routine))
    frame.pose = read(*value);
  else if (!data && key == predefined)
    frame.pose = Eigen::Isometry3d::Identity();
  else if (moved_frames_.count(data) != 0)
    fail_at(argument, routine);
  frames_in_use_.insert(data);
  return frame;
}

void RapidDataState::assign(TokenReader& reader, const RapidRoutine& routine) {
  const TokenReader where = reader;
  const RapidData* data = source_.data(reader.name(), routine);
  const bool whole = reader.at_symbol(':');
  while (!reader.at_symbol('='))
    pass_over_brackets(reader);
  reader.next();
  if (data) {
    forget(*data, where);
    if (whole && reader.at_symbol('[')) changed_[data].value = reader.position();
  }
  pass_over_rapid_statement(reader);
}

void RapidDataState::forget(const RapidData& data, const TokenReader& where) {
  if (frames_in_use_.count(&data) != 0) moved_frames_.insert(&data);
  changed_[&data] = {std::nullopt, where.place().file, where.place().line};
}

void RapidDataState::forget_assigned(std::size_t begin, std::size_t end,
                                     const RapidRoutine& routine) {
  TokenReader reader = source_.reader(routine.file, begin);
  bool option = false;  // \WObj:= is not an assignment
  while (!reader.at_end() && reader.position() < end) {
    if (!option && at_rapid_assignment(reader))
      if (const RapidData* data = source_.data(std::string(reader.peek().text), routine))
        forget(*data, reader);
    option = reader.at_symbol('\\');
    reader.next();
  }
}

}  // namespace tool_path_programs
