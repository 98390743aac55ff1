// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/border/border_distance.h"

namespace part_recipes::path_design {

/// Consecutive places beside a border that are nearer to no border than they should be.
struct OffsetRun {
  std::vector<TracePoint> points;
  std::size_t next = 0;       //!< number of the next run of the same border
  Eigen::Vector3d first_way;  //!< along the border at its begin, unit length
  Eigen::Vector3d last_way;   //!< along the border at its end, unit length
};

/// What is left of the lines beside all borders.
struct OffsetRuns {
  std::vector<OffsetRun> all;  //!< border by border, in the borders' order
  double step = 0;             //!< [m] between places along straight sides
};

/// @param borders closed, the surface on their left
/// @param distance [m] as offset_from() takes it, not 0
OffsetRuns offset_runs(const MeshSearch& surface, const std::vector<Trace>& borders,
                       const BorderDistance& border_distance, double distance);

/// Adds a place unless it is the last one.
void add_apart(const TracePoint& point, std::vector<TracePoint>& points);

}  // namespace part_recipes::path_design
