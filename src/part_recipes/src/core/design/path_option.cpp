// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "design/recipe_path.h"
#include "path_design/path_parameters.h"
#include "scan_cell_common/parameters/each_parameter.h"

namespace part_recipes {
namespace {

using scan_cell_common::Parameter;
using scan_cell_common::ParameterValue;

/// As the tool takes it, where a document says "none".
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

std::vector<PathOption> options_of(PathWay way) {
  if (way == PathWay::kEdge) return options_in(EdgeParameters());
  return way == PathWay::kSlices ? options_in(SliceParameters()) : options_in(PickParameters());
}

}  // namespace part_recipes
