// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/parameters/parameter_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {
namespace {

Parameter of_range(const std::string& name, const ParameterTable::Range& range,
                   const std::string& meaning) {
  Parameter parameter{name, range.unit, meaning};
  parameter.min = range.min;
  parameter.max = range.max;
  parameter.also = range.also;
  return parameter;
}

}  // namespace

template <class T>
void ParameterTable::visit_as(const Parameter& parameter, T& value) {
  ParameterValue visited = value;
  visit(parameter, visited);
  value = std::get<T>(visited);
}

void ParameterTable::add(const std::string& name, bool& value, const std::string& meaning) {
  visit_as(Parameter{prefix_ + name, "", meaning}, value);
}

void ParameterTable::add(const std::string& name, std::string& value, const std::string& meaning) {
  visit_as(Parameter{prefix_ + name, "", meaning}, value);
}

void ParameterTable::add(const std::string& name, double& value, const Range& range,
                         const std::string& meaning) {
  const Parameter parameter = of_range(prefix_ + name, range, meaning);
  visit_as(parameter, value);
  check_range(parameter, value);
}

void ParameterTable::add(const std::string& name, std::vector<double>& value, const Range& range,
                         const std::string& meaning, std::size_t count) {
  Parameter parameter = of_range(prefix_ + name, range, meaning);
  parameter.count = count;
  visit_as(parameter, value);
  if (count != 0 && !value.empty() && value.size() != count)
    refuse(name, fmt::format("{} numbers", value.size()), fmt::format("give {}", count));
  for (const double number : value)
    check_range(parameter, number);
}

std::int64_t ParameterTable::whole(const std::string& name, std::int64_t value, const Range& range,
                                   const std::string& meaning) {
  const Parameter parameter = of_range(prefix_ + name, range, meaning);
  visit_as(parameter, value);
  check_range(parameter, static_cast<double>(value));
  return value;
}

void ParameterTable::require(const std::string& name, std::string& value,
                             const std::string& meaning) {
  Parameter parameter{prefix_ + name, "", meaning};
  parameter.required = true;
  visit_as(parameter, value);
}

void ParameterTable::choice(const std::string& name, std::string& value,
                            const std::vector<std::string>& words, const std::string& meaning) {
  Parameter parameter{prefix_ + name, "", meaning};
  parameter.words = words;
  visit_as(parameter, value);
  if (std::find(words.begin(), words.end(), value) != words.end()) return;
  refuse(name, "'" + value + "'", fmt::format("give one of {}", fmt::join(words, ", ")));
}

std::size_t ParameterTable::place(const std::string& name, std::size_t value,
                                  const std::vector<std::string>& words,
                                  const std::string& meaning) {
  std::string word = words.at(value);
  choice(name, word, words, meaning);
  return static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin());
}

void ParameterTable::renamed(const std::string& old, const std::string& now) {
  if (!is_given(prefix_ + old, prefix_ + now)) return;
  refuse(old, "renamed", fmt::format("use {}", prefix_ + now));
}

void ParameterTable::refuse(const std::string& name, const std::string& value,
                            const std::string& cure) const {
  throw InvalidParameter(full_name(name), value, cure);
}

void ParameterTable::check_range(const Parameter& parameter, double value) const {
  if (value >= parameter.min && value <= parameter.max) return;  // false for NaN
  if (parameter.also == Also::kZero && value == 0) return;
  if (parameter.also == Also::kNone && std::isinf(value)) return;
  throw InvalidParameter(named(parameter.name), fmt::format("{:g}", value),
                         fmt::format("give a value from {:g} to {:g}{}", parameter.min,
                                     parameter.max, parameter.also == Also::kZero ? ", or 0" : ""));
}

}  // namespace scan_cell_common
