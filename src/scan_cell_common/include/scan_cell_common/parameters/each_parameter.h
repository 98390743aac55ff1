// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <utility>

#include "scan_cell_common/parameters/parameter_table.h"

namespace scan_cell_common {

/// Applies one action to each parameter of a table.
class EachParameter final : public ParameterTable {
 public:
  /// May replace the value.
  using Act = std::function<void(const Parameter& parameter, ParameterValue& value)>;

  /// @param act called while the table is described
  explicit EachParameter(Act act) : act_(std::move(act)) {}

 private:
  void visit(const Parameter& parameter, ParameterValue& value) override { act_(parameter, value); }
  bool is_given(const std::string&, const std::string&) override { return false; }

  Act act_;
};

}  // namespace scan_cell_common
