// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/parameters/parameter_table.h"

/// Expectations of every package's tests about its parameters.
namespace scan_cell_common {

/// A table in which one parameter is given by its old name.
class OldName final : public ParameterTable {
 public:
  /// @param old name that must be refused with the new one
  explicit OldName(const std::string& old) : old_(old) {}

  bool has(const std::string& name) const {
    return names_.count(name) != 0;
  }  //!< whether the table has this parameter

 private:
  void visit(const Parameter& parameter, ParameterValue&) override {
    names_.insert(parameter.name);
  }
  bool is_given(const std::string& old, const std::string&) override { return old == old_; }

  std::string old_;
  std::set<std::string> names_;
};

/// Expects that each old name is refused, with the new one in the message.
template <class Parameters>
void expect_renamed(const std::vector<std::pair<std::string, std::string>>& names) {
  for (const auto& [old, now] : names) {
    Parameters parameters;
    OldName table(old);
    try {
      describe(table, parameters);
      ADD_FAILURE() << old << " is not refused";
    } catch (const InvalidParameter& error) {
      EXPECT_EQ(error.what(), old + ": renamed; use " + now);
    }
    OldName all("");
    describe(all, parameters);
    EXPECT_TRUE(all.has(now)) << now;
  }
}

/// Expects each row of the parameters' table in a document, in order.
template <class Parameters>
void expect_documented(const std::string& document, const std::string& how_to_list_them) {
  const std::string text = read_file(document);
  EXPECT_NE(text.find(parameter_rows<Parameters>()), std::string::npos)
      << document << " does not hold the table that " << how_to_list_them << " prints:\n"
      << parameter_rows<Parameters>();
}

}  // namespace scan_cell_common
