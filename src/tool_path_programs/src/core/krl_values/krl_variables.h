// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "krl_values/krl_source.h"

namespace tool_path_programs {

/// Values of names while a program runs: of the routine, of its file's data list, global.
class KrlVariables {
 public:
  explicit KrlVariables(const KrlSource& source) : source_(source), data_(source.data()) {}

  void enter(std::size_t file);  //!< when a routine begins
  void leave();                  //!< when it ends: its declarations are dropped

  void declare(const std::string& name);
  void assign(const std::string& name, const KrlValue& value);

  /// null: no value is known from the files.
  const KrlValue* find(const std::string& name) const;

 private:
  struct Scope {
    std::size_t file;
    std::set<std::string> declared;
    std::map<std::string, KrlValue> values;
  };

  const KrlSource& source_;
  std::map<std::string, KrlValue> data_;
  std::vector<Scope> scopes_;
};

}  // namespace tool_path_programs
