// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tool_paths {

/// The parts of a column's or key's name, in lower case.
struct NameParts {
  std::vector<std::string> words;  //!< separated by blanks, underscores, points, brackets
  std::string base;                //!< the words without the unit, joined by "_"
  std::string unit;                //!< m, mm, inch, deg, rad; empty: none given
};

NameParts parts_of(const std::string& name);

inline bool is_length_unit(const std::string& unit) {
  return unit == "m" || unit == "mm" || unit == "inch";
}

inline bool is_angle_unit(const std::string& unit) {
  return unit == "deg" || unit == "rad";
}

/// Names that stand for the three or four numbers of an orientation.
struct OrientationNames {
  enum class Kind { kQuaternion, kAnglesByAxis, kAnglesByTurn, kVector };
  Kind kind;
  std::vector<std::string> names;  //!< x y z w; angles about x, y, z; or first to third rotation
};

const std::vector<OrientationNames>& known_orientation_names();

}  // namespace tool_paths
