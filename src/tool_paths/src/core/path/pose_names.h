// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tool_paths/path_conventions.h"

namespace tool_paths {

/// Which of a file's names hold what, by their indices.
struct PoseNames {
  PoseConvention convention;
  std::array<std::size_t, 3> position{};
  std::vector<std::size_t> orientation;  //!< as in PoseConvention::names
  std::vector<std::size_t> process;      //!< all others
};

/// Tells from the names of columns or keys how a pose is written. Names are known in upper and
/// lower case, with a unit behind them (x_mm, a_deg, "rx [rad]").
/// @param where file and line, for errors
/// @throw scan_cell_common::UnusableInput if there is no position, or if a name could be that of an
/// orientation but whose kind is not given
/// @throw scan_cell_common::InvalidParameter if the conventions do not fit the names
PoseNames understand(const std::vector<std::string>& names, const PathConventions& conventions,
                     const std::string& where);

/// Whether a name could be that of an orientation, or of a part of one.
bool could_be_orientation(const std::string& name);

}  // namespace tool_paths
