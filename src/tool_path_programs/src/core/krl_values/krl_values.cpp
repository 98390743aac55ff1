// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl_values/krl_values.h"

#include <algorithm>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

std::string field_name(std::size_t field) {
  return lower_case(kKrlFields[field]);
}

/// Goes past the end of braces nested in braces, from after their opening brace.
void skip_braces(TokenReader& reader) {
  reader.expect('{');
  for (std::size_t depth = 1; depth > 0;) {
    if (reader.at_line_end()) reader.fail("braces that are not closed", "close them");
    if (reader.at_symbol('{')) ++depth;
    if (reader.at_symbol('}')) --depth;
    reader.next();
  }
}

/// A name, with its index if it has one: POINT2[].
std::string field(TokenReader& reader) {
  const std::string name = lower_case(reader.name());
  if (reader.accept('['))
    while (!reader.accept(']')) {
      if (reader.at_line_end()) reader.fail("an index that is not closed", "close it with ]");
      reader.next();
    }
  return name;
}

void read_field(TokenReader& reader, KrlAggregate& aggregate) {
  const std::string name = field(reader);
  const TokenKind kind = reader.peek().kind;
  if (reader.at_symbol('{')) {
    skip_braces(reader);
  } else if (kind == TokenKind::kName || kind == TokenKind::kText) {
    aggregate.words[name] = lower_case(reader.next().text);
  } else {
    aggregate.numbers[name] = reader.number();
  }
}

bool is_axis(const std::string& name) {
  return name.size() == 2 && (name[0] == 'a' || name[0] == 'e') && name[1] >= '1' && name[1] <= '6';
}

}  // namespace

std::optional<double> KrlAggregate::number(const std::string& name) const {
  const auto found = numbers.find(name);
  if (found == numbers.end()) return std::nullopt;
  return found->second.value;
}

bool KrlAggregate::has_pose() const {
  for (std::size_t field = 0; field < kKrlFields.size(); ++field)
    if (numbers.count(field_name(field)) > 0 || words.count(field_name(field)) > 0) return true;
  return false;
}

bool KrlAggregate::has_axes() const {
  return !has_pose() && std::any_of(numbers.begin(), numbers.end(),
                                    [](const auto& number) { return is_axis(number.first); });
}

bool KrlAggregate::whole() const {
  for (std::size_t field = 0; field < kKrlFields.size(); ++field)
    if (numbers.count(field_name(field)) == 0) return false;
  return true;
}

KrlNumbers KrlAggregate::over(const KrlNumbers& others) const {
  KrlNumbers result = others;
  for (std::size_t field = 0; field < kKrlFields.size(); ++field)
    if (const auto value = number(field_name(field))) result[field] = *value;
  return result;
}

KrlAggregate read_aggregate(TokenReader& reader) {
  KrlAggregate aggregate;
  aggregate.offset = reader.peek().offset;
  aggregate.place = reader.place();
  reader.expect('{');
  if (reader.peek_after().kind == TokenKind::kSymbol && reader.peek_after().text == ":") {
    reader.name();
    reader.expect(':');
  }
  while (!reader.accept('}')) {
    read_field(reader, aggregate);
    if (!reader.at_symbol('}')) reader.expect(',');
  }
  return aggregate;
}

KrlValue read_value(TokenReader& reader) {
  KrlValue value;
  value.place = reader.place();
  const TokenKind kind = reader.peek().kind;
  if (reader.at_symbol('{'))
    value.aggregate = read_aggregate(reader);
  else if (kind == TokenKind::kNumber || reader.at_symbol('-') || reader.at_symbol('+')) {
    if (kind != TokenKind::kNumber && reader.peek_after().kind != TokenKind::kNumber) return value;
    value.number = reader.number().value;
  }
  if (reader.at_line_end() || reader.at_symbol(',')) return value;
  return KrlValue{{}, {}, value.place};
}

std::string read_variable(TokenReader& reader) {
  std::string name = lower_case(reader.name());
  if (!reader.accept('[')) return name;
  const bool known = reader.peek().kind == TokenKind::kNumber;
  if (known) name += "[" + shortest(reader.next().number, 3) + "]";
  if (reader.accept(']')) return known ? name : "";
  while (!reader.at_line_end() && !reader.accept(']'))
    reader.next();
  return "";
}

}  // namespace tool_path_programs
