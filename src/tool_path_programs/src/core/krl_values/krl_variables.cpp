// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl_values/krl_variables.h"

namespace tool_path_programs {
namespace {

/// points[3] is declared as points.
std::string array_of(const std::string& name) {
  return name.substr(0, name.find('['));
}

const KrlValue* value_in(const std::map<std::string, KrlValue>& values, const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? nullptr : &found->second;
}

}  // namespace

void KrlVariables::enter(std::size_t file) {
  scopes_.push_back({file, {}, {}});
}

void KrlVariables::leave() {
  scopes_.pop_back();
}

void KrlVariables::declare(const std::string& name) {
  scopes_.back().declared.insert(array_of(name));
}

void KrlVariables::assign(const std::string& name, const KrlValue& value) {
  Scope& scope = scopes_.back();
  const std::string own = source_.scope(scope.file) + name;
  if (scope.declared.count(array_of(name)) > 0)
    scope.values[name] = value;
  else if (data_.count(own) == 0 && data_.count(name) > 0)
    data_[name] = value;
  else
    data_[own] = value;
}

const KrlValue* KrlVariables::find(const std::string& name) const {
  const Scope& scope = scopes_.back();
  if (scope.declared.count(array_of(name)) > 0) return value_in(scope.values, name);
  const KrlValue* own = value_in(data_, source_.scope(scope.file) + name);
  return own ? own : value_in(data_, name);
}

}  // namespace tool_path_programs
