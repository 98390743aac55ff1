// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tool_paths {

/// A column's or key's name in its parts, in lower case.
struct NameParts {
  std::vector<std::string> words;  //!< between blanks, underscores, points, brackets
  std::string base;                //!< the words but for the unit, joined by "_"
  std::string unit;                //!< m, mm, inch, deg, rad; empty: none is given
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
  std::vector<std::string> names;  //!< x y z w; of the angles about x, y, z; first to third turn
};

const std::vector<OrientationNames>& known_orientation_names();

}  // namespace tool_paths
