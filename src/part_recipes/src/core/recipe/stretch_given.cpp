// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "recipe/stretch_given.h"

#include <sstream>
#include <variant>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace part_recipes {
namespace {

/// The whole text as a value of that kind.
template <class T>
bool read_value(const std::string& text, T& value) {
  std::istringstream stream(text);
  return (stream >> std::boolalpha >> value) && (stream >> std::ws).eof();
}

bool read_value(const std::string& text, std::string& value) {
  value = text;
  return true;
}

bool read_value(const std::string& text, std::vector<double>& value) {
  std::istringstream stream(text);
  value.clear();
  for (double number = 0; stream >> number;)
    value.push_back(number);
  return stream.eof();
}

/// Reads what a recipe gives for each parameter.
class ParametersGiven final : public scan_cell_common::ParameterTable {
 public:
  explicit ParametersGiven(const ToolOptions& given) : given_(given) {}

 private:
  void visit(const scan_cell_common::Parameter& parameter,
             scan_cell_common::ParameterValue& value) override {
    const auto found = given_.find(parameter.name);
    if (found == given_.end()) return;
    const bool is_read =
        std::visit([&](auto& typed) { return read_value(found->second, typed); }, value);
    if (!is_read)
      throw scan_cell_common::UnusableInput(named(parameter.name), "'" + found->second + "'",
                                            "see docs/tool_path_stretcher.md");
  }
  bool is_given(const std::string& old, const std::string&) override {
    return given_.count(old) != 0;
  }
  std::string named(const std::string& name) const override { return "stretch." + name; }

  const ToolOptions& given_;
};

}  // namespace

tool_path_stretcher::StretchParameters stretch_parameters_of(const Recipe& recipe) {
  ParametersGiven table(recipe.stretch);
  tool_path_stretcher::StretchParameters parameters;
  describe(table, parameters);
  return parameters;
}

}  // namespace part_recipes
