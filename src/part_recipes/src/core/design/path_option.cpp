// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <set>
#include <sstream>

#include "design/recipe_path.h"
#include "path_design/path_parameters.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/parameters/each_parameter.h"

namespace part_recipes {
namespace {

using scan_cell_common::Parameter;
using scan_cell_common::ParameterValue;

/// The value as the tool takes it, where a document says "none".
std::string value_text(const Parameter& parameter, const ParameterValue& value) {
  const auto* const numbers = std::get_if<std::vector<double>>(&value);
  if (numbers != nullptr) return fmt::format("{}", fmt::join(*numbers, " "));
  return default_text(parameter, value);
}

template <class Parameters>
std::vector<PathOption> options_in(Parameters parameters) {
  std::vector<PathOption> options;
  scan_cell_common::EachParameter table([&](const Parameter& parameter, ParameterValue& value) {
    PathOption option = {parameter.name,
                         parameter.unit,
                         value_text(parameter, value),
                         range_text(parameter, value),
                         parameter.words,
                         parameter.meaning};
    if (std::holds_alternative<bool>(value)) option.words = {"false", "true"};
    options.push_back(std::move(option));
  });
  describe(table, parameters);
  return options;
}

}  // namespace

PathParameters surface_parameters(const ToolOptions& options) {
  const std::set<std::string> looked_at = {"from", "leaf", "crease_angle"};
  PickParameters parameters;
  scan_cell_common::EachParameter table([&](const Parameter& parameter, ParameterValue& value) {
    const auto given = options.find(parameter.name);
    if (given == options.end() || looked_at.count(parameter.name) == 0) return;
    std::vector<double> numbers;
    std::istringstream words(given->second);
    for (std::string word; words >> word;) {
      const auto number = scan_cell_common::parse_number(word);
      if (!number)
        throw scan_cell_common::InvalidParameter(parameter.name, "'" + word + "'", "give numbers");
      numbers.push_back(*number);
    }
    if (std::holds_alternative<double>(value) && numbers.size() == 1)
      value = numbers.front();
    else if (std::holds_alternative<std::vector<double>>(value) && numbers.size() == 3)
      value = numbers;
    else
      throw scan_cell_common::InvalidParameter(parameter.name, "'" + given->second + "'",
                                               "give " + range_text(parameter, value));
  });
  describe(table, parameters);
  return parameters.path;
}

std::vector<PathOption> options_of(PathWay way) {
  if (way == PathWay::kEdge) return options_in(EdgeParameters());
  return way == PathWay::kSlices ? options_in(SliceParameters()) : options_in(PickParameters());
}

}  // namespace part_recipes
