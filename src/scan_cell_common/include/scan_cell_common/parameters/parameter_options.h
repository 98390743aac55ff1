// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scan_cell_common/parameters/parameter_table.h"

namespace CLI {
class App;
}

namespace scan_cell_common {

/// Options of a tool from a table of parameters: `--min-scale` for min_scale, with its meaning,
/// unit, range and default in --help.
///
///     ParameterOptions options;
///     options.add(app, parameters);   // before the command line is parsed
///     options.read(parameters);       // after it
class ParameterOptions {
 public:
  /// @param only names to take; empty: all
  template <class Parameters>
  void add(CLI::App& app, Parameters defaults, const std::set<std::string>& only = {}) {
    Declared table(app, only, given_);
    describe(table, defaults);
  }

  /// Replaces the defaults by the values given.
  /// @throw InvalidParameter naming the option
  template <class Parameters>
  void read(Parameters& parameters) const {
    Typed table(given_);
    describe(table, parameters);
  }

 private:
  using Given = std::map<std::string, std::vector<std::string>>;  // words by option

  class Declared final : public ParameterTable {
   public:
    Declared(CLI::App& app, const std::set<std::string>& only, Given& given)
        : app_(app), only_(only), given_(given) {}

   private:
    void visit(const Parameter& parameter, ParameterValue& value) override;
    bool is_given(const std::string& old, const std::string& now) override;
    bool is_taken(const std::string& name) const;

    CLI::App& app_;
    const std::set<std::string>& only_;
    Given& given_;
  };

  class Typed final : public ParameterTable {
   public:
    explicit Typed(const Given& given) : given_(given) {}

   private:
    void visit(const Parameter& parameter, ParameterValue& value) override;
    bool is_given(const std::string&, const std::string&) override { return false; }
    std::string named(const std::string& name) const override;

    const Given& given_;
  };

  Given given_;
};

/// Refuses an option's old name and gives the new one. --help does not list it.
/// @param names old and new, such as {"--most-skew", "--max-skew"}
void refuse_renamed(CLI::App& app, const std::vector<std::pair<std::string, std::string>>& names);

}  // namespace scan_cell_common
