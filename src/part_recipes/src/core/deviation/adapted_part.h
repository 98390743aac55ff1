// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "tool_path_stretcher/similarity.h"

namespace part_recipes {

/// Files and units that an adaptation was made from.
struct AdaptedFiles {
  std::string reference;        //!< cloud or mesh
  std::string reference_units;  //!< m, mm or inch; empty: as the report says
  std::string object;           //!< cloud, in metres; empty: not given
  std::string report;           //!< of stretch
};

/// How the reference lies on the object.
struct AdaptedPart {
  std::optional<tool_path_stretcher::Similarity> similarity;  //!< the best; none: refused before
  double metres_per_unit = 1;                                 //!< of the reference
};

/// Reads the report.
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput if the report is none, is
/// about other files, or says other units
AdaptedPart load_adapted_part(const AdaptedFiles& files);

}  // namespace part_recipes
