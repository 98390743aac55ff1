// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "scan_cell_common/clouds/fielded_cloud.h"

namespace part_recipes {

/// Tolerances from the middle of the scale to its ends, on the pages of runs and in rviz.
constexpr double kColourSpan = 2;

/// The cloud with a field rgb more, as rviz takes it: its field deviation [m] on a scale that the
/// tolerance fixes. Without deviations it has one colour.
/// @throw scan_cell_common::UnusableInput as places_of() of the cloud
scan_cell_common::FieldedCloud coloured(const scan_cell_common::FieldedCloud& cloud,
                                        double tolerance);

/// [m] Around all points; empty of none.
/// @throw scan_cell_common::UnusableInput as places_of() of the cloud
Eigen::AlignedBox3d box_of(const scan_cell_common::FieldedCloud& cloud);

/// Where the object is beyond the tolerance: for eyes that do not tell the colours.
struct DeviationMark {
  Eigen::Vector3d position;  //!< [m]
  bool is_more;              //!< material was added, rather than taken
};

/// One mark a cell of a grid over the cloud, by the median of the deviations that are known there;
/// none where that is within the tolerance, or not known of most points.
/// @throw scan_cell_common::UnusableInput as places_of() of the cloud
std::vector<DeviationMark> deviation_marks(const scan_cell_common::FieldedCloud& cloud,
                                           double tolerance);

}  // namespace part_recipes
