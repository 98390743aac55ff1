// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/trace/trace.h"

namespace part_recipes::path_design {

/// A place of a border, and where to leave it.
struct OffsetSource {
  Eigen::Vector3d position;  //!< [m]
  Eigen::Vector3d normal;    //!< unit length
  Eigen::Vector3d inwards;   //!< unit length, in the surface; outwards if asked for
};

/// The sources of the lines beside a border.
struct OffsetSources {
  std::vector<OffsetSource> all;  //!< in the order of the border
  double step = 0;                //!< [m] between them along its sides
};

/// Sources along a closed border, close together. They turn around corners where the lines would
/// part.
/// @param distance [m] as offset_from() takes it, not 0
OffsetSources offset_sources(const Trace& border, double distance);

/// A direction in the plane of a normal, unit length.
Eigen::Vector3d in_plane(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal);

}  // namespace part_recipes::path_design
