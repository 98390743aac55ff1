// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <string>
#include <vector>

#include "scan_cell_common/errors.h"

namespace cloud_preprocess {

/// Each parameter struct is described once, by a template describe(reader, parameters) that names
/// every parameter with its range. Readers are scan_cell_common::ParameterReader (ROS parameters),
/// the YAML reader of load_clean_parameters(), and RangeCheck.

/// A reader that changes nothing and refuses what lies outside its range.
class RangeCheck {
 public:
  struct Range {
    double least;
    double most;
  };

  /// @throw scan_cell_common::InvalidParameter
  static void read(const std::string& name, double value, const Range& range);
  static void read(const std::string& name, int value, const Range& range);
  static void read(const std::string&, bool) {}
  static void read(const std::string& name, const std::vector<double>& value, const Range& range);
  static void read_choice(const std::string&, const std::string&, const std::vector<std::string>&) {
  }
};

/// Three numbers x, y, z.
template <class Reader>
void describe_vector(Reader& reader, const std::string& name, Eigen::Vector3d& value,
                     const typename Reader::Range& range) {
  std::vector<double> numbers(value.begin(), value.end());
  reader.read(name, numbers, range);
  if (numbers.size() != 3) {
    throw scan_cell_common::InvalidParameter(name, std::to_string(numbers.size()) + " numbers",
                                             "give three: x, y and z");
  }
  value = Eigen::Map<const Eigen::Vector3d>(numbers.data());
}

/// One of an enum's words, which stand in the enum's order.
template <class Reader, class Enum>
void describe_choice(Reader& reader, const std::string& name, Enum& value,
                     const std::vector<std::string>& words) {
  std::string word = words.at(static_cast<std::size_t>(value));
  reader.read_choice(name, word, words);
  value = static_cast<Enum>(std::find(words.begin(), words.end(), word) - words.begin());
}

/// @throw scan_cell_common::InvalidParameter naming the parameter that is out of range
template <class Parameters>
void check(Parameters parameters) {
  RangeCheck reader;
  describe(reader, parameters);
}

}  // namespace cloud_preprocess
