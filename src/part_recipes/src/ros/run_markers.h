// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <vector>

#include "view/deviation_colours.h"
#include "view/run_view.h"

/// The markers of a run besides its clouds and paths. Markers without anything to show remove what
/// was there before.
namespace part_recipes {

/// Balls at the waypoints that the verdict is about.
visualization_msgs::Marker concerned_marker(const RunView& view, const std_msgs::Header& header);

/// Waypoints that were not seen. Shape tells them apart, not colour alone: cubes are in a shadow,
/// with a line to what casts it; balls are at too grazing an angle; large cubes are out of range.
visualization_msgs::MarkerArray unseen_markers(const RunView& view, const std_msgs::Header& header);

/// The adapted path, brighter the farther off a waypoint may be, up to the tolerance, and the
/// tool's axes: x red, z blue and longer.
visualization_msgs::MarkerArray expected_markers(const RunView& view,
                                                 const std_msgs::Header& header);

/// The verdict in words over the object, the scale of its colours with figures beside it, and plus
/// and minus signs on the object where it is beyond the tolerance.
/// @param object [m] box around it; empty: there is none
visualization_msgs::MarkerArray sign_markers(const RunView& view,
                                             const std::vector<DeviationMark>& marks,
                                             const Eigen::AlignedBox3d& object,
                                             const std_msgs::Header& header);

}  // namespace part_recipes
