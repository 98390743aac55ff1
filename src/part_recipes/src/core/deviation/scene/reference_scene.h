// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tool_path_stretcher/similarity.h"

namespace part_recipes {

/// What a picture shows of a reference beside an object.
struct ReferenceScene {
  tool_path_stretcher::Points points;  //!< [m] evenly over the surface: where the similarity puts
                                       //!< them, or in the reference's frame where there is none
  std::vector<double> scanned;  //!< 1: the object has a point near it, 0: it has none, NaN: no
                                //!< similarity is known
  std::vector<double> rim;      //!< 1: the surface ends or has a sharp edge here, else 0
};

/// At most 20,000 points of the surface, and as many of its rim.
/// @param reference cloud or mesh
/// @param object [m]; may be empty if there is no similarity
/// @param tolerance [m] of deviations
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput
ReferenceScene load_reference_scene(
    const std::string& reference, double metres_per_unit,
    const std::optional<tool_path_stretcher::Similarity>& similarity,
    const tool_path_stretcher::Points& object, double tolerance);

}  // namespace part_recipes
