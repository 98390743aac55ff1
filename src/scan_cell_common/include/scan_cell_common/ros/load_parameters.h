// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <set>
#include <string>

#include "scan_cell_common/parameters/parameter_table.h"

namespace scan_cell_common {

/// Reads a node's private parameters, and refuses by name any that is of another type, out of
/// range, missing or unknown.
class RosParameters final : public ParameterTable {
 public:
  explicit RosParameters(const ros::NodeHandle& node);

  /// @throw InvalidParameter if a private parameter is set that was never read: otherwise a
  /// misspelt name would silently leave the default. A read of "a" also covers "a/b".
  void refuse_unknown() const;

 private:
  void visit(const Parameter& parameter, ParameterValue& value) override;
  bool is_given(const std::string& old, const std::string& now) override;
  std::string named(const std::string& name) const override;

  ros::NodeHandle node_;
  std::set<std::string> names_;
};

/// All parameters of a node; defaults are in the struct.
/// @throw InvalidParameter naming the bad, missing or unknown parameter
template <class Parameters>
Parameters load_parameters(const ros::NodeHandle& private_node) {
  RosParameters reader(private_node);
  Parameters parameters;
  describe(reader, parameters);
  reader.refuse_unknown();
  return parameters;
}

}  // namespace scan_cell_common
