// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "scan_cell_common/parameters/parameter_table.h"

namespace scan_cell_common {
namespace {

constexpr const char* kNone = "none";

std::string number_text(double value) {
  return std::isfinite(value) ? fmt::format("{:g}", value) : kNone;
}

struct DefaultText {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
  std::string operator()(double value) const { return number_text(value); }
  std::string operator()(const std::string& value) const { return value.empty() ? kNone : value; }
  std::string operator()(const std::vector<double>& value) const {
    const bool none = value.empty() || !std::isfinite(value.front());
    return none ? kNone : fmt::format("{:g}", fmt::join(value, ", "));
  }
};

}  // namespace

std::string range_text(const Parameter& parameter, const ParameterValue& value) {
  if (std::holds_alternative<bool>(value) || std::holds_alternative<std::string>(value))
    return fmt::format("{}", fmt::join(parameter.words, ", "));
  if (!std::isfinite(parameter.min) && !std::isfinite(parameter.max)) return "";
  std::string text = fmt::format("{}{:g} .. {:g}", parameter.also == Also::kZero ? "0, " : "",
                                 parameter.min, parameter.max);
  if (parameter.count != 0) text += fmt::format(", {} numbers", parameter.count);
  return text;
}

std::string default_text(const Parameter& parameter, const ParameterValue& value) {
  return parameter.required ? "required" : std::visit(DefaultText{}, value);
}

void ParameterRows::visit(const Parameter& parameter, ParameterValue& value) {
  const auto cell = [](const std::string& text) { return text.empty() ? " |" : " " + text + " |"; };
  text_ += "| `" + parameter.name + "` |" + cell(parameter.unit) +
           cell(range_text(parameter, value)) + cell(default_text(parameter, value)) +
           cell(parameter.meaning) + "\n";
}

}  // namespace scan_cell_common
