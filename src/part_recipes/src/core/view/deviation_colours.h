// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "scan_cell_common/clouds/fielded_cloud.h"

namespace part_recipes {

/// Tolerances from the middle of the scale to its ends, on the pages of runs and in rviz.
constexpr double kColourSpan = 2;

/// The cloud with an additional field rgb, as rviz takes it. The colour shows its field deviation
/// [m] on a scale that the tolerance fixes. Without deviations the cloud has one colour.
/// @throw scan_cell_common::UnusableInput as places_of() of the cloud
scan_cell_common::FieldedCloud coloured(const scan_cell_common::FieldedCloud& cloud,
                                        double tolerance);

/// [m] Around all points; empty of none.
/// @throw scan_cell_common::UnusableInput as places_of() of the cloud
Eigen::AlignedBox3d box_of(const scan_cell_common::FieldedCloud& cloud);

/// A place where the object is beyond the tolerance, for people who cannot tell the colours.
struct DeviationMark {
  Eigen::Vector3d position;  //!< [m]
  bool is_more;              //!< material was added, rather than taken
};

/// One mark per cell of a grid over the cloud, by the median of the known deviations in the cell;
/// none if that is within the tolerance, or most deviations there are unknown.
/// @throw scan_cell_common::UnusableInput as places_of() of the cloud
std::vector<DeviationMark> deviation_marks(const scan_cell_common::FieldedCloud& cloud,
                                           double tolerance);

}  // namespace part_recipes
