// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/parameters/parameter_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace scan_cell_common {
namespace {

std::string option_of(const std::string& parameter) {
  std::string option = "--" + parameter;
  std::replace(option.begin(), option.end(), '_', '-');
  std::replace(option.begin(), option.end(), '/', '-');
  return option;
}

double number_of(const std::string& option, const std::string& word) {
  const auto number = parse_number(word);
  if (!number) throw InvalidParameter(option, "'" + word + "'", "give a number");
  return *number;
}

/// Converts typed words to the type of a parameter.
struct TakeWords {
  const std::string& option;
  const std::vector<std::string>& words;

  void operator()(bool& value) const { value = words.at(0) == "true"; }
  void operator()(std::string& value) const { value = words.at(0); }
  void operator()(double& value) const { value = number_of(option, words.at(0)); }
  void operator()(std::int64_t& value) const {
    const double number = number_of(option, words.at(0));
    constexpr double kExact = 1e15;  // whole numbers up to it are exact as a double
    if (std::trunc(number) != number || std::abs(number) > kExact)
      throw InvalidParameter(option, words.at(0), "give a whole number");
    value = static_cast<std::int64_t>(number);
  }
  void operator()(std::vector<double>& value) const {
    value.clear();
    for (const std::string& word : words)
      value.push_back(number_of(option, word));
  }
};

std::string help_of(const Parameter& parameter, const ParameterValue& value) {
  const std::string range = range_text(parameter, value);
  std::string help = parameter.meaning;
  if (!parameter.unit.empty()) help += fmt::format(" [{}]", parameter.unit);
  if (!range.empty()) help += fmt::format("{}{}", help.empty() ? "" : "; ", range);
  return help;
}

const char* type_of(const ParameterValue& value) {
  constexpr const char* kTypes[] = {"", "INT", "FLOAT", "TEXT", "FLOAT"};
  return kTypes[value.index()];
}

}  // namespace

bool ParameterOptions::Declared::is_taken(const std::string& name) const {
  return only_.empty() || only_.count(name) != 0;
}

void ParameterOptions::Declared::visit(const Parameter& parameter, ParameterValue& value) {
  if (!is_taken(parameter.name)) return;
  const std::string name = option_of(parameter.name);
  const auto keep = [&given = given_, name](const std::vector<std::string>& words) {
    given[name] = words;
  };
  if (std::holds_alternative<bool>(value)) {
    app_.add_flag_callback(
        name, [keep] { keep({"true"}); }, parameter.meaning);
    return;
  }
  CLI::Option* const option =
      app_.add_option_function<std::vector<std::string>>(name, keep, help_of(parameter, value));
  option->type_name(type_of(value))->required(parameter.required);
  if (!std::holds_alternative<std::vector<double>>(value)) {
    option->expected(1);
  } else if (parameter.count != 0) {
    option->expected(static_cast<int>(parameter.count));
  }
  if (!parameter.required) option->default_str(default_text(parameter, value));
}

bool ParameterOptions::Declared::is_given(const std::string& old, const std::string& now) {
  if (is_taken(now)) refuse_renamed(app_, {{option_of(old), option_of(now)}});
  return false;
}

void ParameterOptions::Typed::visit(const Parameter& parameter, ParameterValue& value) {
  const std::string name = option_of(parameter.name);
  const auto words = given_.find(name);
  if (words != given_.end()) std::visit(TakeWords{name, words->second}, value);
}

std::string ParameterOptions::Typed::named(const std::string& name) const {
  return option_of(name);
}

void refuse_renamed(CLI::App& app, const std::vector<std::pair<std::string, std::string>>& names) {
  constexpr const char* kHidden = "";
  for (const auto& [old, now] : names) {
    const auto refuse = [old = old, now = now](const std::vector<std::string>&) {
      throw InvalidParameter(old, "renamed", fmt::format("use {}", now));
    };
    app.add_option_function<std::vector<std::string>>(old, refuse)
        ->expected(0, CLI::detail::expected_max_vector_size)
        ->group(kHidden);
  }
}

}  // namespace scan_cell_common
