// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tool_paths/tool_path.h"

namespace part_recipes {

/// A waypoint that the scan could not see.
struct UnseenWaypoint {
  std::string sight;                        //!< shadowed, grazing or out_of_range
  Eigen::Vector3d position;                 //!< [m] of its place on the surface
  std::optional<Eigen::Vector3d> obstacle;  //!< [m] what stands in the way of light or sight
};

/// What can be shown of a run besides its cloud.
struct RunView {
  std::string frame;                     //!< of all: the recipe's for work, else world
  tool_paths::ToolPath path;             //!< the proven one, where the similarity puts it [m]
  tool_paths::ToolPath adapted;          //!< [m]; without segments where the run was not accepted
  std::vector<std::uint32_t> concerned;  //!< waypoints that the verdict is about
  tool_paths::Points positions;          //!< of these [m]
  std::string verdict;                   //!< for a person: its word, and why
  double tolerance = 0;                  //!< [m] of the recipe's deviations
  /// [m] expected error of each waypoint of `adapted`, along the normal and the surface, one
  /// standard deviation; NaN: not known. Empty if nothing was adapted.
  std::vector<double> expected;
  std::vector<UnseenWaypoint> unseen;  //!< empty if nobody looked
};

/// The view of a run's folder. It is empty for a run that ended before there was a report.
/// @throw scan_cell_common::Error from the readers of its files
RunView view_of(const std::filesystem::path& run);

}  // namespace part_recipes
