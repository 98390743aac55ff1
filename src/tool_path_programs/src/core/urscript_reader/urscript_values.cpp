// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "urscript_reader/urscript_values.h"

#include <utility>

namespace tool_path_programs {

ScriptValue ScriptVariables::value(const std::string& name) const {
  ScriptValue result;
  result.kind = ScriptValue::Kind::kFree;
  if (changing_.count(name) != 0) {
    result.kind = ScriptValue::Kind::kComputed;
  } else if (locals_ && locals_->count(name) != 0) {
    result = locals_->at(name);
  } else if (const auto at = globals_.find(name); at != globals_.end()) {
    result = at->second;
  }
  result.name = name;
  return result;
}

void ScriptVariables::assign(const std::string& name, ScriptValue value) {
  if (!locals_ || (locals_->count(name) == 0 && globals_.count(name) != 0))
    assign_globally(name, std::move(value));
  else
    assign_locally(name, std::move(value));
}

void ScriptVariables::assign_globally(const std::string& name, ScriptValue value) {
  globals_[name] = std::move(value);
}

void ScriptVariables::assign_locally(const std::string& name, ScriptValue value) {
  if (locals_)
    (*locals_)[name] = std::move(value);
  else
    globals_[name] = std::move(value);
}

void ScriptVariables::forget(const std::string& name) {
  globals_[name] = ScriptValue();
  if (locals_ && locals_->count(name) != 0) (*locals_)[name] = ScriptValue();
}

std::optional<ScriptVariables::Locals> ScriptVariables::begin_function(Locals parameters) {
  return std::exchange(locals_, std::move(parameters));
}

}  // namespace tool_path_programs
