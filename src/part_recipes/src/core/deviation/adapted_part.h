// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "tool_path_stretcher/similarity.h"

namespace part_recipes {

/// Files and units of an adaptation.
struct AdaptedFiles {
  std::string reference;        //!< cloud or mesh
  std::string reference_units;  //!< m, mm or inch; empty: as the report says
  std::string object;           //!< cloud, in metres; empty: not given
  std::string report;           //!< of stretch
};

/// Pose of the reference on the object.
struct AdaptedPart {
  std::optional<tool_path_stretcher::Similarity> similarity;  //!< the best; none: refused earlier
  double metres_per_unit = 1;                                 //!< of the reference
};

/// Reads the report.
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput if the file is not a report,
/// or the report is about other files or gives other units
AdaptedPart load_adapted_part(const AdaptedFiles& files);

}  // namespace part_recipes
