// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "deviation/deviations.h"
#include "deviation/places.h"
#include "deviation/reference/reference_surface.h"

namespace part_recipes {

/// The measured deviations, for deviation.json (docs/run_report.md).
struct DeviationSummary {
  double tolerance = 0;  //!< [m] half width
  Deviations deviations;
  std::vector<PlaceDeviation> places;
  double unscanned_share = 0;  //!< of the reference's samples, without a point of the object near
  OutsideKnownBy outside = OutsideKnownBy::kUpwards;
};

/// JSON, lengths in metres; null where not known.
std::string to_json(const DeviationSummary& summary);

/// Writes points with additional float32 fields, as binary PLY or PCD.
/// @param names of the fields
/// @param fields one list per name, with one value per point
/// @throw scan_cell_common::FileError if it cannot be written
void save_fields(const std::string& file, const Points& points,
                 const std::vector<std::string>& names,
                 const std::vector<std::vector<double>>& fields);

}  // namespace part_recipes
