// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Geometry>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace scan_cell_common {

/// @throw FileError if it is missing, unreadable or not YAML; UnusableInput if it is not UTF-8
YAML::Node load_yaml(const std::string& path);

/// The same for text already in memory.
/// @param name of the text, for errors
/// @throw FileError if it is not YAML; UnusableInput if it is not UTF-8
YAML::Node parse_yaml(const std::string& text, const std::string& name);

/// One entry of a YAML file. Errors name the file, the entry's full path, such as "scanner.yaml:
/// camera.fx", and its line; for a missing entry, the line of the map it belongs in.
class YamlEntry {
 public:
  /// The root of a file.
  /// @throw FileError, UnusableInput as load_yaml()
  static YamlEntry load(const std::string& path);

  /// The root of a text. @throw FileError, UnusableInput as parse_yaml()
  static YamlEntry parse(const std::string& text, const std::string& name);

  /// @param file, name file and full path of the entry, for errors
  YamlEntry(const YAML::Node& node, const std::string& file, const std::string& name = "");

  bool is_map() const;                     //!< whether it has keys
  bool is_list() const;                    //!< whether it has elements
  bool is_null() const;                    //!< whether it is present but empty: ~
  bool has(const std::string& key) const;  //!< whether it is a map with this key

  /// @throw UnusableInput if it is missing
  YamlEntry operator[](const std::string& key) const;

  /// @throw UnusableInput if it has another type
  template <class T>
  T as() const {
    try {
      return node_.as<T>();
    } catch (const YAML::Exception&) {
      refuse("wrong type", "correct it");
    }
  }

  /// A list of exactly N finite numbers.
  /// @throw UnusableInput if it is not
  template <int N>
  Eigen::Matrix<double, N, 1> vector() const {
    return Eigen::Map<const Eigen::Matrix<double, N, 1>>(numbers(N).data());
  }

  /// A vector of any length above 0, normalised; one of length 1 within rounding is returned
  /// unchanged to the last digit.
  /// @throw UnusableInput if it is not such a vector
  Eigen::Vector3d direction() const;

  /// A map of `translation` [m] and `rotation` (unit quaternion x y z w).
  /// @throw UnusableInput if one is missing or invalid
  Eigen::Isometry3d pose() const;

  /// The elements of a list.
  /// @throw UnusableInput if it is not a list
  std::vector<YamlEntry> elements() const;

  /// The entries of a map, with their keys, in the order of the file.
  /// @throw UnusableInput if it is not a map
  std::vector<std::pair<std::string, YamlEntry>> entries() const;

  /// @throw UnusableInput if a key is not among `known`, or this is no map
  void refuse_unknown(const std::set<std::string>& known) const;

  /// @throw UnusableInput about this entry
  [[noreturn]] void refuse(const std::string& value, const std::string& cure) const;

  const std::string& name() const { return name_; }  //!< the entry's full path in the file

 private:
  std::vector<double> numbers(std::size_t count) const;
  std::string child(const std::string& key) const;

  YAML::Node node_;
  std::string file_;
  std::string name_;
};

/// In the form that YamlEntry::vector() reads, to the last digit, on one line.
YAML::Node yaml_list(const Eigen::VectorXd& numbers);

/// In the form that YamlEntry::pose() reads, to the last digit.
YAML::Node yaml_pose(const Eigen::Isometry3d& pose);

}  // namespace scan_cell_common
