// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>

#include "cloud_preprocess/clean.h"

namespace cloud_preprocess {

/// Size and density of a cloud.
struct CloudSize {
  Eigen::Vector3d extent = Eigen::Vector3d::Zero();  //!< along x, y, z, without a few outermost
  double spacing = 0;  //!< typical distance between neighbouring points; 0: unknown
};

/// Measures the finite points within the limits of all stages; zero if there are none.
CloudSize measure(const Cloud& cloud, const CleanParameters& parameters);

/// "0.3 x 0.2 x 0.05 m, 0.6 mm between points", for a size in metres.
std::string text_of(const CloudSize& size);

/// Refuses a file's cloud that contains a scanner's number for "nothing measured" as a point, or
/// whose size makes no sense in its unit: nothing that a robot scans is larger than 20 m or smaller
/// than 1 mm, and no scan of a part has points more than 6 mm apart.
/// @param cloud [m]
/// @param unit of the file; empty: not given, metres were assumed. A given unit is refused only if
/// the cloud would be smaller than 1 mm.
/// @param name of the cloud in errors
/// @throw scan_cell_common::UnusableInput naming the number, or the unit that makes sense
void check_input(const Cloud& cloud, const CleanParameters& parameters, const std::string& unit,
                 const std::string& name);

}  // namespace cloud_preprocess
