// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <set>
#include <string>
#include <vector>

namespace scan_cell_common {

/// Reads a node's private parameters into its parameter struct, and refuses bad ones by name.
///
///     ParameterReader reader(private_node_handle);
///     Parameters parameters;                                   // defaults stand in the struct
///     reader.read("rate", parameters.rate, Range{1.0, 1000.0});
///     reader.require("port", parameters.port);
///     reader.refuse_unknown();
class ParameterReader {
 public:
  struct Range {
    double least;
    double most;
  };

  explicit ParameterReader(const ros::NodeHandle& node);

  /// Leaves `value` as it is where the parameter is not set.
  /// @throw InvalidParameter if it has another type, is not finite or lies outside `range`
  void read(const std::string& name, double& value, const Range& range);
  void read(const std::string& name, int& value, const Range& range);
  void read(const std::string& name, bool& value);
  void read(const std::string& name, std::string& value);
  void read(const std::string& name, std::vector<double>& value, const Range& range);

  /// One of a few words.
  /// @throw InvalidParameter naming the words allowed
  void read_choice(const std::string& name, std::string& value,
                   const std::vector<std::string>& choices);

  /// @throw InvalidParameter if the parameter is not set, or is bad
  template <class T, class... Limits>
  void require(const std::string& name, T& value, const Limits&... limits) {
    throw_if_missing(name);
    read(name, value, limits...);
  }

  /// @throw InvalidParameter if a private parameter is set that was never read: a misspelt name
  /// would otherwise be taken for the default in silence. A read of "a" covers "a/b" too.
  void refuse_unknown() const;

 private:
  void throw_if_missing(const std::string& name) const;

  template <class T>
  bool get(const std::string& name, const char* type, T& value);

  ros::NodeHandle node_;
  std::set<std::string> names_;
};

}  // namespace scan_cell_common
