// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tool_paths/path_conventions.h"

namespace tool_paths {

/// The meaning of a file's names, by index.
struct PoseNames {
  PoseConvention convention;
  std::array<std::size_t, 3> position{};
  std::vector<std::size_t> orientation;  //!< in the order of PoseConvention::names
  std::vector<std::size_t> process;      //!< all others
};

/// Determines from the names of columns or keys how a pose is written. Names may be upper or lower
/// case, and a unit may follow (x_mm, a_deg, "rx [rad]").
/// @param where file and line, for errors
/// @throw scan_cell_common::UnusableInput if there is no position, or if a name could be that of an
/// orientation whose kind is not given
/// @throw scan_cell_common::InvalidParameter if the conventions do not fit the names
PoseNames understand(const std::vector<std::string>& names, const PathConventions& conventions,
                     const std::string& where);

/// Whether a name could be that of an orientation or a part of one.
bool could_be_orientation(const std::string& name);

}  // namespace tool_paths
